#include "drivers/web/response.h"

#include <microhttpd.h>
#include <sys/stat.h>

#include <fmt/format.h>

namespace kaori::web {

// MHD's signature is older than const.
MHD_Response* TextResponse(std::string_view text) {
  auto* bytes = const_cast<char*>(text.data());
  return MHD_create_response_from_buffer(text.size(), bytes, MHD_RESPMEM_MUST_COPY);
}

// MHD closes the descriptor, and reads by places of its own in the file.
MHD_Response* FileResponse(UniqueFd file, const std::string& name) {
  struct stat status {};
  if (::fstat(file.get(), &status) < 0) return nullptr;
  MHD_Response* response =
      MHD_create_response_from_fd64(static_cast<std::uint64_t>(status.st_size), file.get());
  if (response == nullptr) return nullptr;
  (void)file.release();
  MHD_add_response_header(response, MHD_HTTP_HEADER_CONTENT_DISPOSITION,
                          fmt::format("attachment; filename=\"{}\"", name).c_str());
  return response;
}

}  // namespace kaori::web
