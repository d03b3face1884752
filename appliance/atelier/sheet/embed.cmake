# Writes OUTPUT, a C++ file that carries the text file FILE as kPage.
file(READ ${FILE} text)
file(WRITE ${OUTPUT} "#include \"appliance/atelier/sheet/page_text.h\"

namespace kaori::atelier {

const std::string_view kPage = R\"PAGE(${text})PAGE\";

}  // namespace kaori::atelier
")
