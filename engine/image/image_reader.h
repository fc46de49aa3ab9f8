#pragma once
/// An opened picture file, for the parts of loading. Not for others: image_io.h is.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/error.h"
#include "image/image_io.h"

namespace tyndall::reading {

[[noreturn]] void fail(std::string_view name, std::string message, std::string expected = {},
                       std::string suggestion = {});

/// An opened picture; `proxy` is read from while it lives.
struct Reader {
    std::string name;
    std::unique_ptr<OIIO::Filesystem::IOMemReader> proxy;
    std::unique_ptr<OIIO::ImageInput> input;

    Reader(std::string_view content, std::string_view picture_name);
    Reader(const std::filesystem::path& file, std::string_view format);

    [[nodiscard]] const OIIO::ImageSpec& spec() const { return input->spec(); }
    /// All channels, in the file's own type. Memory is taken as rows arrive: a small file that promises a huge picture
    /// costs nothing.
    [[nodiscard]] Image read() { return read(0, spec().nchannels, false); }
    /// Some of the channels.
    [[nodiscard]] Image read(int first_channel, int last_channel, bool as_float);

 private:
    [[nodiscard]] std::string reason() const;
    void open(const std::string& as);
};

/// OpenImageIO and the libraries below it report by return value and by exception; both become Errors that name the
/// file.
template <class Work>
auto guarded(std::string_view name, Work&& work) {
    try {
        return work();
    } catch (const Error& error) {
        if (!error.diagnostics().front().where.file.empty()) throw;
        throw Error(error).within(std::string(name));
    } catch (const std::exception& error) {
        fail(name, std::string("cannot be read: ") + error.what());
    }
}

/// Opens a file by the kind that its first bytes tell; `whole`: its end is looked at too, where the reader would not.
[[nodiscard]] Reader open_file(const std::filesystem::path& file, bool whole);

}  // namespace tyndall::reading
