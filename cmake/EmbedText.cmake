# cmake -DOUTPUT=FILE -DROOT=FOLDER "-DFILES=a;b;…" "-DVARIABLE=TYPE NAME" -DHEADER=FILE [-DWITHOUT=include|pragma] -P EmbedText.cmake
#
# Writes a C++ file that defines `const TYPE NAME[]`, declared in HEADER: {name, text} of each file (below ROOT) in order,
# then {nullptr, nullptr}. One string a file, so that a line of which a driver complains can be named. The
# preprocessor directives named by WITHOUT are left out of the texts.
set(text "// Made by cmake/EmbedText.cmake from the files it names.\n#include \"${HEADER}\"\n\n")
string(REGEX REPLACE "/.*" "" room "${HEADER}")
string(APPEND text "namespace glint::${room} {\n\nconst ${VARIABLE}[] = {\n")
foreach(file IN LISTS FILES)
    file(READ "${ROOT}/${file}" code)
    if(WITHOUT)
        string(REGEX REPLACE "#(${WITHOUT})[^\n]*" "" code "${code}")
    endif()
    string(APPEND text "    {\"${file}\", R\"embedded(${code})embedded\"},\n")
endforeach()
string(APPEND text "    {nullptr, nullptr}};\n\n} // namespace glint::${room}\n")
file(WRITE "${OUTPUT}" "${text}")
