# Writes OUTPUT, a C++ file that carries the text file FILE as kSheetPage.
file(READ ${FILE} text)
file(WRITE ${OUTPUT} "#include \"appliance/authoring/sheet/page_text.h\"

namespace kaori::authoring {

const std::string_view kSheetPage = R\"PAGE(${text})PAGE\";

}  // namespace kaori::authoring
")
