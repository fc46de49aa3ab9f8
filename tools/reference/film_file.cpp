// Films as EXR files. OpenEXR itself reads and writes them: the sums need integer channels beside the floats.

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <list>
#include <sstream>

#include "core/error.h"
#include "reference/film.h"

namespace tyndall::reference {
namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "the sums' words are written lowest first");

namespace {

constexpr const char* kFormat = "1";

[[noreturn]] void fail(const fs::path& file, std::string message, std::string expected = {}) {
    throw Error(Diagnostic{{file.string()}, std::move(message), std::move(expected), {}});
}

/// FNV-1a, a word at a time: OpenEXR notices damage in compressed blocks only.
uint64_t checksum(uint64_t hash, const void* bytes, size_t size) {
    const auto* words = static_cast<const uint32_t*>(bytes);
    for (size_t i = 0; i < size / 4; ++i) hash = (hash ^ words[i]) * 0x100000001b3ull;
    return hash;
}

/// "0-11,14" of a set of numbers.
std::string ranges_text(const std::set<int64_t>& numbers) {
    std::string text;
    for (auto first = numbers.begin(); first != numbers.end();) {
        auto last = first;
        while (std::next(last) != numbers.end() && *std::next(last) == *last + 1) ++last;
        if (!text.empty()) text += ",";
        text += first == last ? fmt::format("{}", *first) : fmt::format("{}-{}", *first, *last);
        first = std::next(last);
    }
    return text;
}

std::set<int64_t> ranges_of(const fs::path& file, const std::string& text) {
    std::set<int64_t> numbers;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, ',');) {
        int64_t first = -1, last = -1;
        const char* end = part.data() + part.size();
        const auto [at, error] = std::from_chars(part.data(), end, first);
        if (error == std::errc{}) last = first;
        if (error == std::errc{} && at != end && *at == '-') std::from_chars(at + 1, end, last);
        if (first < 0 || last < first || last - first > (int64_t{1} << 24))
            fail(file, "the film's list of batches is damaged: '" + text + "'");
        for (int64_t i = first; i <= last; ++i) numbers.insert(numbers.end(), i);
    }
    return numbers;
}

/// Names of the sums in the order in which a pixel holds them, and the 32-bit words of each.
struct SumName {
    const char* name;
    int words;
};
constexpr SumName kPixelSums[] = {{"radiance.R", 4}, {"radiance.G", 4}, {"radiance.B", 4}, {"squares.R", 4},
                                  {"squares.G", 4},  {"squares.B", 4},  {"albedo.R", 2},   {"albedo.G", 2},
                                  {"albedo.B", 2},   {"normal.X", 2},   {"normal.Y", 2},   {"normal.Z", 2}};
constexpr SumName kComponentSums[] = {{"emission.R", 4}, {"emission.G", 4}, {"emission.B", 4},
                                      {"surface.R", 4},  {"surface.G", 4},  {"surface.B", 4},
                                      {"medium.R", 4},   {"medium.G", 4},   {"medium.B", 4}};

/// Lets OpenEXR read or write an array of records as integer channels in place.
template <size_t N>
void add_sums(Imf::Header* header, Imf::FrameBuffer& buffer, const SumName (&names)[N], void* records, size_t stride,
              int width) {
    auto* word = static_cast<char*>(records);
    for (const SumName& sum : names)
        for (int w = 0; w < sum.words; ++w, word += 4) {
            const std::string name = fmt::format("sum.{}.{}", sum.name, w);
            if (header) header->channels().insert(name, Imf::Channel(Imf::UINT));
            buffer.insert(name, Imf::Slice(Imf::UINT, word, stride, stride * static_cast<size_t>(width)));
        }
}

/// Float pictures on their way into a file.
class Layers {
 public:
    void add(Imf::Header& header, Imf::FrameBuffer& buffer, Image image, std::initializer_list<std::string> names) {
        images_.push_back(std::move(image));
        Image& kept = images_.back();
        const size_t stride = static_cast<size_t>(kept.channels) * sizeof(float);
        auto* at = reinterpret_cast<char*>(kept.floats().data());
        for (const std::string& name : names) {
            header.channels().insert(name, Imf::Channel(Imf::FLOAT));
            buffer.insert(name, Imf::Slice(Imf::FLOAT, at, stride, stride * static_cast<size_t>(kept.width)));
            at += sizeof(float);
        }
    }

 private:
    std::list<Image> images_;
};

Image sample_counts(const Film& film) {
    Image image(film.size().x, film.size().y, 1, Image::Type::f32);
    for (float& value : image.floats()) value = static_cast<float>(film.samples());
    return image;
}

void add_layers(const Film& film, Imf::Header& header, Imf::FrameBuffer& buffer, Layers& layers) {
    layers.add(header, buffer, film.radiance(), {"R", "G", "B"});
    layers.add(header, buffer, film.variance(), {"variance.R", "variance.G", "variance.B"});
    layers.add(header, buffer, sample_counts(film), {"samples"});
    layers.add(header, buffer, film.albedo(), {"albedo.R", "albedo.G", "albedo.B"});
    layers.add(header, buffer, film.normal(), {"normal.X", "normal.Y", "normal.Z"});
    if (!film.has_components()) return;
    constexpr std::pair<Component, const char*> kParts[] = {{Component::emission, "emission"},
                                                            {Component::surface, "surface"},
                                                            {Component::medium, "medium"},
                                                            {Component::multiple, "multiple"}};
    for (const auto& [part, name] : kParts)
        layers.add(header, buffer, film.component(part),
                   {fmt::format("{}.R", name), fmt::format("{}.G", name), fmt::format("{}.B", name)});
}

std::string text_attribute(const fs::path& file, const Imf::Header& header, const char* name) {
    const auto* found = header.findTypedAttribute<Imf::StringAttribute>(name);
    if (!found) fail(file, "this picture is not a traced film", "an EXR written by tyndall trace, with its sums");
    return found->value();
}

/// Makes what was written last through a crash, and puts it in place of `file`.
void put_in_place(const fs::path& temporary, const fs::path& file) {
    const int descriptor = open(temporary.c_str(), O_RDONLY);
    const bool synced = descriptor >= 0 && fsync(descriptor) == 0;
    if (descriptor >= 0) close(descriptor);
    if (!synced || std::rename(temporary.c_str(), file.c_str()) != 0)
        fail(file, fmt::format("cannot write: {}", std::strerror(errno)));
}

}  // namespace

uint64_t Film::sum_checksum() const {
    uint64_t hash = checksum(0xcbf29ce484222325ull, pixels_.data(), pixels_.size() * sizeof(Pixel));
    return checksum(hash, components_.data(), components_.size() * sizeof(Components));
}

void Film::save(const fs::path& file) const {
    Imf::Header header(size_.x, size_.y);
    header.compression() = Imf::ZIP_COMPRESSION;
    const auto attribute = [&](const char* name, const std::string& value) {
        header.insert(name, Imf::StringAttribute(value));
    };
    attribute("tyndall.film", kFormat);
    attribute("tyndall.recipe", recipe_);
    attribute("tyndall.batch", fmt::format("{}", batch_));
    attribute("tyndall.unit", fmt::format("{:a}", unit_));
    attribute("tyndall.batches", ranges_text(done_));
    attribute("tyndall.components", has_components() ? "yes" : "no");
    attribute("tyndall.checksum", fmt::format("{:016x}", sum_checksum()));
    Imf::FrameBuffer buffer;
    Layers layers;
    add_layers(*this, header, buffer, layers);
    auto& pixels = const_cast<std::vector<Pixel>&>(pixels_);  // OpenEXR's slices are not const; writing only reads them
    auto& parts = const_cast<std::vector<Components>&>(components_);
    add_sums(&header, buffer, kPixelSums, pixels.data(), sizeof(Pixel), size_.x);
    if (has_components()) add_sums(&header, buffer, kComponentSums, parts.data(), sizeof(Components), size_.x);
    // A folder cannot be replaced by a file; a device or a pipe could, and would be lost.
    if (fs::exists(file) && !fs::is_regular_file(file)) fail(file, "cannot write: there is something that is no file");
    const fs::path temporary = file.string() + fmt::format(".{}.part", getpid());
    try {
        std::ofstream stream(temporary, std::ios::binary);
        if (!stream) throw std::runtime_error(std::strerror(errno));
        {
            Imf::StdOFStream bytes(stream, temporary.c_str());
            Imf::OutputFile out(bytes, header);
            out.setFrameBuffer(buffer);
            out.writePixels(size_.y);
        }
        stream.close();  // OpenEXR ends its file, and its stream, without a look at what became of the last bytes
        if (!stream) throw std::runtime_error(errno != 0 ? std::strerror(errno) : "the disk is full");
        put_in_place(temporary, file);
    } catch (const Error&) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw;
    } catch (const std::exception& error) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        fail(file, fmt::format("cannot write: {}", error.what()));
    }
}

Film Film::load(const fs::path& file) {
    if (!fs::is_regular_file(file)) fail(file, "no such file");
    try {
        Imf::InputFile in(file.c_str());
        const Imf::Header& header = in.header();
        if (text_attribute(file, header, "tyndall.film") != kFormat)
            fail(file, "the film was written by another version of tyndall trace");
        const Imath::Box2i window = header.dataWindow();
        const glm::ivec2 size(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1);
        Film film(size, std::max(1, std::atoi(text_attribute(file, header, "tyndall.batch").c_str())),
                  std::strtof(text_attribute(file, header, "tyndall.unit").c_str(), nullptr),
                  text_attribute(file, header, "tyndall.recipe"),
                  text_attribute(file, header, "tyndall.components") == "yes");
        film.done_ = ranges_of(file, text_attribute(file, header, "tyndall.batches"));
        Imf::FrameBuffer buffer;
        add_sums(nullptr, buffer, kPixelSums, film.pixels_.data(), sizeof(Pixel), size.x);
        if (film.has_components())
            add_sums(nullptr, buffer, kComponentSums, film.components_.data(), sizeof(Components), size.x);
        in.setFrameBuffer(buffer);
        in.readPixels(window.min.y, window.max.y);
        if (fmt::format("{:016x}", film.sum_checksum()) != text_attribute(file, header, "tyndall.checksum"))
            fail(file, "the film's sums are damaged: their checksum is wrong");
        return film;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        fail(file, fmt::format("cannot read the film: {}", error.what()));
    }
}

}  // namespace tyndall::reference
