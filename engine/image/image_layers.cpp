#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "image/image_reader.h"

namespace tyndall {
namespace {

using reading::Reader;

std::string layer_of(const std::string& channel) {
    const size_t dot = channel.rfind('.');
    return dot == std::string::npos ? "" : channel.substr(0, dot);
}

std::vector<std::string> layers_of(const Reader& reader) {
    std::vector<std::string> layers;
    for (const std::string& channel : reader.spec().channelnames)
        if (std::string layer = layer_of(channel); std::ranges::find(layers, layer) == layers.end())
            layers.push_back(std::move(layer));
    return layers;
}

std::string quoted(std::vector<std::string> layers) {
    for (std::string& layer : layers) layer = layer.empty() ? "the plain channels" : "'" + layer + "'";
    return fmt::format("{}", fmt::join(layers, ", "));
}

constexpr std::string_view kOrder[] = {"R", "G", "B", "X", "Y", "Z", "A"};
constexpr int kRanks = static_cast<int>(std::size(kOrder));

/// Where a channel stands among those of its layer: colours and coordinates in their usual order, others after them.
int rank(const std::string& channel) {
    const std::string_view last = std::string_view(channel).substr(channel.rfind('.') + 1);
    for (int i = 0; i < kRanks; ++i)
        if (std::ranges::equal(last, kOrder[i], {}, [](unsigned char c) { return std::toupper(c); })) return i;
    return kRanks;
}

/// The file's indices of a layer's channels, in order: its colours or coordinates, or all when it has none of these. A
/// channel's whole name is a layer of one.
std::vector<int> channels_of(const Reader& reader, std::string_view layer) {
    const std::vector<std::string>& names = reader.spec().channelnames;
    const auto rank_of = [&](int i) { return rank(names[static_cast<size_t>(i)]); };
    std::vector<int> channels;
    for (int i = 0; i < static_cast<int>(names.size()); ++i) {
        if (names[static_cast<size_t>(i)] == layer) return {i};
        if (layer_of(names[static_cast<size_t>(i)]) == layer) channels.push_back(i);
    }
    std::ranges::stable_sort(channels, {}, rank_of);
    if (std::ranges::any_of(channels, [&](int i) { return rank_of(i) < kRanks; }))
        std::erase_if(channels, [&](int i) { return rank_of(i) >= kRanks; });
    return channels;
}

/// The layer's own name, or what the empty name may stand for.
std::string existing(const Reader& reader, std::string_view layer) {
    const std::vector<std::string> layers = layers_of(reader);
    const bool is_channel = std::ranges::find(reader.spec().channelnames, layer) != reader.spec().channelnames.end();
    if (is_channel || std::ranges::find(layers, layer) != layers.end()) return std::string(layer);
    if (layer.empty() && layers.size() == 1) return layers.front();
    reading::fail(reader.name, layer.empty() ? "no channels without a layer" : fmt::format("unknown layer '{}'", layer),
                  "one of " + quoted(layers), nearest_name(layer, layers));
}

}  // namespace

std::vector<std::string> load_layer_names(const std::filesystem::path& file) {
    return reading::guarded(file.string(), [&] { return layers_of(reading::open_file(file, false)); });
}

Image load_layer(const std::filesystem::path& file, std::string_view layer) {
    return reading::guarded(file.string(), [&] {
        Reader reader = reading::open_file(file, true);
        const std::vector<int> channels = channels_of(reader, existing(reader, layer));
        if (channels.size() > 4)
            reading::fail(reader.name, fmt::format("layer '{}' has {} channels", layer, channels.size()),
                          "at most four");
        const auto [first, last] = std::ranges::minmax(channels);
        const Image span = reader.read(first, last + 1, true);
        Image image(span.width, span.height, static_cast<int>(channels.size()), Image::Type::f32);
        for (size_t pixel = 0; pixel < image.value_count() / channels.size(); ++pixel)
            for (size_t c = 0; c < channels.size(); ++c)
                image.floats()[pixel * channels.size() + c] = span.floats()[pixel * static_cast<size_t>(span.channels) +
                                                                            static_cast<size_t>(channels[c] - first)];
        return image;
    });
}

}  // namespace tyndall
