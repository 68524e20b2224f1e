# cmake -DINPUT=file -DOUTPUT=file.cpp -DSPACE=a::b -DNAME=name -P embed.cmake: a source that defines, in that
# namespace, `extern const std::string_view NAME`: the file's bytes. Characters, not a literal: compilers limit its
# length.
foreach(variable INPUT OUTPUT SPACE NAME)
  if(NOT DEFINED ${variable})
    message(FATAL_ERROR "embed.cmake: -D${variable}=... is missing")
  endif()
endforeach()
file(READ "${INPUT}" bytes HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
get_filename_component(file "${INPUT}" NAME)
file(WRITE "${OUTPUT}" "// The bytes of ${file}.
#include <string_view>

namespace ${SPACE} {

extern const std::string_view ${NAME};
static constexpr char bytes[] = {${bytes}'\\0'};
constinit const std::string_view ${NAME}(bytes, sizeof bytes - 1);

}  // namespace ${SPACE}
")
