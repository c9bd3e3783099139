# cmake -DOUTPUT=FILE -DROOT=FOLDER "-DFILES=a;b;…" -P ShaderText.cmake
#
# Writes a C++ file with the text of the shader: its files (below ROOT) in order, one string each, so that a line that
# a driver complains of can be named. What C++ alone must read of shared headers is taken out.
set(text "// Made by cmake/ShaderText.cmake from the files it names.\n#include \"gpu/shader_text.h\"\n\n")
string(APPEND text "namespace glint {\n\nconst ShaderFile shader_files[] = {\n")
foreach(file IN LISTS FILES)
    file(READ "${ROOT}/${file}" code)
    string(REGEX REPLACE "#(include|pragma)[^\n]*" "" code "${code}")
    string(APPEND text "    {\"${file}\", R\"glsl(${code})glsl\"},\n")
endforeach()
string(APPEND text "    {nullptr, nullptr}};\n\n} // namespace glint\n")
file(WRITE "${OUTPUT}" "${text}")
