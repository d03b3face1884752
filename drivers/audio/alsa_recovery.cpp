#include <cerrno>

#include "drivers/audio/alsa_pcm.h"

namespace kaori::audio {

// The causes that callers tell apart. EINVAL comes from refused parameters,
// ENXIO and ENODEV from a card that was pulled.
std::errc CauseOf(long answer) {
  // ENOENT is ALSA's answer to a name that its configuration does not know.
  switch (-answer) {
    case ENODEV:
    case ENXIO:
    case ENOENT:
      return std::errc::no_such_device;
    case EBUSY:
      return std::errc::device_or_resource_busy;
    case EACCES:
    case EPERM:
      return std::errc::permission_denied;
    case EINVAL:
      return std::errc::not_supported;
    default:
      return std::errc::io_error;
  }
}

// EPIPE is an xrun, ESTRPIPE a stream that was suspended; all others end the stream (ALSA's PCM interface).
Result<void> Recover(AlsaPcm& pcm, long answer, const std::string& name) {
  if (answer != -EPIPE && answer != -ESTRPIPE) {
    const bool gone = CauseOf(answer) == std::errc::no_such_device;
    return Fail(gone ? std::errc::no_such_device : std::errc::io_error, "stream " + name);
  }
  if (answer == -ESTRPIPE) {
    const int resumed = pcm.Resume();
    if (resumed == 0) return {};
    if (resumed == -EAGAIN) return Fail(std::errc::resource_unavailable_try_again, "resume " + name);
  }
  // Also where a device cannot resume (-ENOSYS): its queue is lost, and the stream begins anew.
  const int prepared = pcm.Prepare();
  if (prepared == 0) return {};
  const bool gone = CauseOf(prepared) == std::errc::no_such_device;
  return Fail(gone ? std::errc::no_such_device : std::errc::io_error, "recover " + name);
}

}  // namespace kaori::audio
