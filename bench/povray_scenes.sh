# The report's scenes in POV-Ray's language, and how programs are measured: for bench/povray and
# bench/povray-antialiased, which set $folder.
# shellcheck shell=bash
: "${folder:?}"

# The room, its lights and the camera in POV-Ray's language, at a depth and with an ambient light. Its lights fade as
# 2/(1 + d^2): so half the intensity. Of the walls one is a mirror and the floor a little, unless `mirrors` is 0.
room() {
    local depth=$1 ambient=$2 mirrors=${3-1}
    cat <<SCENE
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level $depth + 1 ambient_light rgb $ambient }
#declare D = vnormalize(<0.5, -0.4, -0.1>);
#declare R = vnormalize(vcross(D, <0, 0, 1>));
#declare H = tan(radians(89.30959669 / 2));
camera { location <-50, 40, 10> direction D right 2 * H * R up 2 * H * vcross(R, D) }
light_source { <-70, 15, 10> rgb 500 fade_distance 1 fade_power 2 }
plane { z, -20 pigment { rgb <0.5294, 0.8078, 0.9804> } finish { ambient 1 diffuse 1 reflection 0.2 * $mirrors } }
plane { -x, -30 pigment { rgb 1 } finish { ambient 1 diffuse 1 reflection $mirrors } }
plane { y, -40 pigment { rgb 1 } finish { ambient 1 diffuse 1 } }
SCENE
}

# A ball: centre and radius, colour as POV-Ray writes it, finish, more.
ball() { echo "sphere { $1 pigment { $2 } finish { ambient 1 $3 } ${4-} }"; }

orange="rgb <1, 0.6078, 0.2745>"
violet="rgb <0.5412, 0.1686, 0.8863>"
large="<-20, 16, 0>, 10"
small="<-35, 16, 0>, 5"
raised="<-35, 33, 5>, 5"

twin() {
    case $1 in
    diffuse)
        room 3 0.1 0
        ball "$large" "$orange" "diffuse 1"
        ball "$small" "rgb <0, 1, 0.498>" "diffuse 1"
        ;;
    specular | specular2)
        room 3 0.1
        if [ "$1" = specular ]; then ball "$large" "$orange" "diffuse 1 reflection 1"; else
            ball "$large" "$orange" "diffuse 0 reflection 1"
        fi
        ball "$small" "rgb <0, 1, 0.498>" "diffuse 1 reflection 0.3"
        ;;
    high_10_0.5)
        room 3 0.05
        ball "<-30, 26, 0>, 10" "$violet" "diffuse 1 phong 0.5 phong_size 10"
        ;;
    cylinder)
        room 3 0.1
        echo "cylinder { <-20, 16, -20>, <-20, 16, 0>, 10 pigment { $violet }
            finish { ambient 1 diffuse 1 reflection 0.1 } }"
        ball "$small" "rgb <0, 1, 0.498>" "diffuse 1 reflection 0.3"
        ;;
    transparency)
        room 3 0.1
        ball "<-10, 6, 0>, 10" "$orange" "diffuse 1 reflection 1"
        ball "<-25, 6, 0>, 5" "rgbt <0, 1, 0.498, 0.8>" "diffuse 1 reflection 0.3" "interior { ior 1 }"
        ;;
    transparency2 | transparency3)
        room 4 0.1
        ball "$large" "$violet" "diffuse 1 reflection 0.1"
        if [ "$1" = transparency2 ]; then ball "$small" "rgbt <0, 1, 0.498, 0.7>" "diffuse 0.5" "interior { ior 1 }"; else
            ball "<-35, 26, 0>, 5" "rgbt <0, 1, 0.498, 0.7>" "diffuse 0.5" "interior { ior 1 }"
        fi
        ;;
    refract1)
        room 3 0.05
        ball "$large" "$violet" "diffuse 1 reflection 0.1"
        ball "$raised" "rgbt <0, 1, 0.498, 1>" "diffuse 0 reflection 0.6" "interior { ior 1.2 }"
        ;;
    refract2)
        room 3 0.1
        ball "$large" "$violet" "diffuse 1 reflection 0.1"
        ball "$raised" "rgbt <0, 0, 0, 1>" "diffuse 0 reflection 0.5" "interior { ior 1.1 }"
        ;;
    refract3)
        room 3 0.1
        ball "$large" "$violet" "diffuse 1 reflection 0.1"
        ball "$raised" "rgbt <0, 1, 0.498, 1>" "diffuse 0 reflection 0.3" "interior { ior 1.1 }"
        ;;
    mesh)
        room 3 0.1
        echo "#include \"$folder/room_mesh.inc\""
        echo "object { room_mesh pigment { $orange } finish { ambient 1 diffuse 0.4 reflection 0.6 } }"
        ;;
    esac
    [ "$1" = high_10_0.5 ] || echo "light_source { <-10, 50, 10> rgb 400 fade_distance 1 fade_power 2 }"
}

# room_mesh FILE: the report's room with a mirrored mesh, for both programs.
room_mesh() {
    twin mesh >"$folder/mesh.pov"
    build/bench/bench/glint-pov-mesh "$1" "$folder/room_mesh.ply" "$folder/room_mesh.inc"
    # Of the report's scene all but the balls.
    {
        awk '/^\[\[sphere\]\]/ { ball = 1 } /^\[\[(plane|light)\]\]/ { ball = 0 } !ball' scenes/report/specular.toml |
            sed '/^\[material.orange\]/,/^$/ { s/^diffuse = .*/diffuse = 0.4/; s/^reflectivity = .*/reflectivity = 0.6/ }'
        printf '[[mesh]]\nfile = "room_mesh.ply"\nnormals = "flat"\nmaterial = "orange"\n'
    } >"$folder/mesh.toml"
}

# gyroid FILE: a mesh of 70,000 triangles.
gyroid() { build/bench/tools/meshgen/glint-meshgen gyroid --triangles 70000 --flat -o "$1"; }

# CPU seconds of a command; what it prints goes to $folder/$1.log.
cpu_seconds() {
    local log=$folder/$1.log TIMEFORMAT='%U %S'
    shift
    { time "$@" >"$log" 2>&1; } 2>&1 | awk '{ print $1 + $2 }'
}

median() { sort -g | awk '{ v[NR] = $1 } END { print NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2 }'; }
