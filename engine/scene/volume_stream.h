#pragma once
/// Loading the frames of volume sequences in a thread of its own.

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <tuple>

#include "core/error.h"
#include "scene/render_scene.h"
#include "scene/volume_sequence.h"

namespace tyndall {

/// One file of a sequence as a scene names it.
struct VolumeFrame {
    std::string name;
    GridChoice grid;
    auto operator<=>(const VolumeFrame&) const = default;
};

/// Keeps the last frames that were asked for and the next ones: at most kMostFrames of all sequences and kMostBytes.
/// All functions are for one thread; the loading itself is done in another, which starts when it is first needed.
class VolumeStream {
 public:
    static constexpr size_t kMostFrames = 24;
    static constexpr size_t kMostBytes = size_t{1} << 30;
    static constexpr int kAhead = 3;  ///< so many frames are loaded before they are shown

    struct Source {
        VolumeFrame frame;
        std::filesystem::path file;
    };
    /// Finds a frame's file; may throw Error.
    using Locate = std::function<Source(const VolumeFrame&)>;

    VolumeStream() = default;
    ~VolumeStream();
    VolumeStream(const VolumeStream&) = delete;
    VolumeStream& operator=(const VolumeStream&) = delete;

    /// See AssetStore::sequence_frame.
    [[nodiscard]] std::shared_ptr<const VolumeAsset> frame(const VolumeSequence& sequence, int index,
                                                           const Locate& locate, bool wait);
    /// Forgets all frames.
    void clear();

 private:
    struct Entry {
        std::filesystem::path file;
        std::shared_ptr<const VolumeAsset> asset;
        std::optional<Error> error;
        bool told = false;  ///< the error was logged
        uint64_t used = 0;  ///< when it was last asked for
        [[nodiscard]] bool done() const { return asset || error; }
    };
    using Entries = std::map<VolumeFrame, Entry>;

    Entry& request(const VolumeFrame& frame, const Locate& locate, bool urgent);
    std::shared_ptr<const VolumeAsset> last_good(const std::string& key, Entry& entry);
    void evict();
    void work();

    std::mutex mutex_;
    std::condition_variable wanted_, finished_;
    Entries entries_;                ///< guarded by mutex_, as all below
    std::deque<VolumeFrame> queue_;  ///< next first
    bool ending_ = false;
    uint64_t clock_ = 0;
    std::map<std::string, std::shared_ptr<const VolumeAsset>> last_;  ///< by sequence
    std::thread thread_;
};

}  // namespace tyndall
