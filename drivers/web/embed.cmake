# Writes OUTPUT, a C++ file that carries the files FILES (paths below FOLDER, ;-separated) as bytes: it defines the
# function FindPageFile that HEADER declares in the namespace kaori::NAMESPACE.
set(types html text/html css text/css js text/javascript svg image/svg+xml)
set(arrays "")
set(rows "")
set(number 0)
foreach(file ${FILES})
  file(READ ${FOLDER}/${file} hex HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${hex}")
  string(REGEX MATCH "[a-z]+$" suffix ${file})
  list(FIND types ${suffix} at)
  math(EXPR at "${at} + 1")
  list(GET types ${at} type)
  string(REGEX REPLACE "^index.html$" "" path ${file})
  string(APPEND arrays "constexpr char kFile${number}[] = {${bytes}};\n")
  string(APPEND rows "    {\"/${path}\", \"${type}; charset=utf-8\", {kFile${number}, sizeof(kFile${number})}},\n")
  math(EXPR number "${number} + 1")
endforeach()
file(WRITE ${OUTPUT} "#include \"${HEADER}\"

namespace kaori::${NAMESPACE} {
namespace {

${arrays}
constexpr web::PageFile kFiles[] = {
${rows}};

}  // namespace

const web::PageFile* FindPageFile(std::string_view path) {
  for (const web::PageFile& file : kFiles)
    if (file.path == path) return &file;
  return nullptr;
}

}  // namespace kaori::${NAMESPACE}
")
