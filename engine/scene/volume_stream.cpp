#include "scene/volume_stream.h"

#include <algorithm>
#include <cmath>

#include "core/log.h"
#include "image/volume.h"

namespace tyndall {

int frame_count(const VolumeSequence& sequence) {
    return std::max((sequence.last - sequence.first) / std::max(sequence.step, 1), 0) + 1;
}

int frame_at(const VolumeSequence& sequence, double time_s) {
    const double frames = std::floor((time_s - double(sequence.start_s)) * double(sequence.frames_per_s) + 1e-6);
    const double count = frame_count(sequence);
    if (!(frames > 0.0)) return 0;
    return int(sequence.playback == Playback::loop ? std::fmod(frames, count) : std::min(frames, count - 1.0));
}

int frame_after(const VolumeSequence& sequence, int index) {
    const int count = frame_count(sequence);
    return sequence.playback == Playback::loop ? (index + 1) % count : std::min(index + 1, count - 1);
}

std::string frame_name(const VolumeSequence& sequence, int index) {
    const size_t end = sequence.file.find_last_of('#');
    if (end == std::string::npos) return sequence.file;
    size_t begin = end;
    while (begin > 0 && sequence.file[begin - 1] == '#') --begin;
    std::string number = std::to_string(sequence.first + index * std::max(sequence.step, 1));
    if (number.size() < end + 1 - begin) number.insert(0, end + 1 - begin - number.size(), '0');
    return sequence.file.substr(0, begin) + number + sequence.file.substr(end + 1);
}

namespace {

std::string key_of(const VolumeSequence& sequence) {
    return sequence.file + '\n' + sequence.grid.name + '\n' + sequence.grid.velocity + '\n' +
           std::to_string(sequence.grid.shutter_s) + '\n' + std::to_string(sequence.first) + '\n' +
           std::to_string(sequence.last);
}

}  // namespace

VolumeStream::~VolumeStream() {
    {
        const std::scoped_lock lock(mutex_);
        ending_ = true;
    }
    wanted_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void VolumeStream::clear() {
    const std::scoped_lock lock(mutex_);
    queue_.clear();
    entries_.clear();
    last_.clear();
}

std::shared_ptr<const VolumeAsset> VolumeStream::frame(const VolumeSequence& sequence, int index, const Locate& locate,
                                                       bool wait) {
    std::unique_lock lock(mutex_);
    ++clock_;
    const VolumeFrame wanted{frame_name(sequence, index), sequence.grid};
    request(wanted, locate, true);
    for (int ahead = 0, next = index; ahead < kAhead; ++ahead) {
        next = frame_after(sequence, next);
        try {
            request({frame_name(sequence, next), sequence.grid}, locate, false);
        } catch (const Error&) {
            break;  // is reported when its turn comes
        }
    }
    if (!thread_.joinable()) thread_ = std::thread([this] { work(); });
    wanted_.notify_one();
    if (wait) finished_.wait(lock, [&] { return entries_.at(wanted).done(); });
    Entry& entry = entries_.at(wanted);
    if (wait && entry.error) throw Error(*entry.error);
    std::shared_ptr<const VolumeAsset> shown = last_good(key_of(sequence), entry);
    evict();
    return shown;
}

VolumeStream::Entry& VolumeStream::request(const VolumeFrame& frame, const Locate& locate, bool urgent) {
    auto found = entries_.find(frame);
    if (found == entries_.end()) {
        const Source source = locate(frame);
        found = entries_.emplace(frame, Entry{.file = source.file, .asset = {}, .error = {}}).first;
        queue_.push_back(frame);
    }
    found->second.used = clock_;
    if (urgent && !found->second.done()) {
        const auto queued = std::ranges::find(queue_, frame);
        if (queued != queue_.end()) {
            queue_.erase(queued);
            queue_.push_front(frame);
        }
    }
    return found->second;
}

std::shared_ptr<const VolumeAsset> VolumeStream::last_good(const std::string& key, Entry& entry) {
    if (entry.error && !entry.told) {
        log::error("{}\n  the frame that was shown before stays", entry.error->what());
        entry.told = true;
    }
    std::shared_ptr<const VolumeAsset>& last = last_[key];
    if (entry.asset) last = entry.asset;
    return last;
}

void VolumeStream::evict() {
    size_t frames = 0, bytes = 0;
    for (const auto& [frame, entry] : entries_)
        if (entry.asset) ++frames, bytes += entry.asset->volume.values.size() * sizeof(float);
    while (frames > kMostFrames || bytes > kMostBytes) {
        auto oldest = entries_.end();
        for (auto at = entries_.begin(); at != entries_.end(); ++at)
            if (at->second.asset && at->second.used < clock_ &&
                (oldest == entries_.end() || at->second.used < oldest->second.used))
                oldest = at;
        if (oldest == entries_.end()) return;  // all are wanted now
        --frames;
        bytes -= oldest->second.asset->volume.values.size() * sizeof(float);
        entries_.erase(oldest);
    }
}

void VolumeStream::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        wanted_.wait(lock, [&] { return ending_ || !queue_.empty(); });
        if (ending_) return;
        const VolumeFrame frame = queue_.front();
        queue_.pop_front();
        const auto entry = entries_.find(frame);
        if (entry == entries_.end()) continue;
        const std::filesystem::path file = entry->second.file;
        lock.unlock();
        Entry made{.file = file, .asset = {}, .error = {}};
        try {
            made.asset = std::make_shared<const VolumeAsset>(
                VolumeAsset{new_asset_id(), frame.name, load_volume(file, frame.grid)});
        } catch (const Error& error) {
            made.error = error;
        }
        lock.lock();
        if (const auto still = entries_.find(frame); still != entries_.end()) {
            made.used = still->second.used;
            still->second = std::move(made);
        }
        finished_.notify_all();
    }
}

}  // namespace tyndall
