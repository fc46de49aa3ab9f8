#include "render/graph_textures.h"

#include <algorithm>

namespace tyndall {
namespace {

/// Textures for what is wanted and not among `spare`. May throw, so it comes before anything changes hands.
template <class Wanted>
std::vector<gpu::Texture> make_missing(const Wanted& wanted, std::vector<gpu::TextureDesc> spare) {
    std::vector<gpu::Texture> made;
    for (const auto& want : wanted) {
        const auto found = std::ranges::find(spare, want.desc);
        if (found == spare.end())
            made.emplace_back(want.desc, want.name);
        else
            spare.erase(found);
    }
    return made;
}

gpu::Texture take(std::vector<gpu::Texture>& pool, const gpu::TextureDesc& desc) {
    const auto found = std::ranges::find(pool, desc, &gpu::Texture::desc);
    gpu::Texture texture = std::move(*found);
    pool.erase(found);
    return texture;
}

}  // namespace

GraphTextures::GraphTextures(const GraphPlan& plan, glm::ivec2 frame_size, GraphTextures& old) {
    const std::vector<NamedDesc> wanted = lay_out(plan, frame_size);
    std::vector<gpu::TextureDesc> spare;
    for (const Slot& slot : old.slots_) spare.push_back(slot.texture.desc());
    std::vector<gpu::Texture> pool = make_missing(wanted, std::move(spare));
    std::vector<History*> kept(histories_.size(), nullptr);
    for (size_t i = 0; i < histories_.size(); ++i) {
        for (History& known : old.histories_)
            if (known.name == histories_[i].name && known.desc == histories_[i].desc) kept[i] = &known;
        if (kept[i] != nullptr) continue;
        for (gpu::Texture& texture : histories_[i].textures)
            texture = gpu::Texture(histories_[i].desc, histories_[i].name);
    }
    // From here on nothing throws: `old` may be taken apart.
    for (Slot& slot : old.slots_) pool.push_back(std::move(slot.texture));
    old.slots_.clear();
    for (size_t i = 0; i < slots_.size(); ++i) slots_[i].texture = take(pool, wanted[i].desc);
    for (size_t i = 0; i < histories_.size(); ++i)
        if (kept[i] != nullptr) histories_[i] = std::move(*kept[i]);
}

std::vector<GraphTextures::NamedDesc> GraphTextures::lay_out(const GraphPlan& plan, glm::ivec2 frame_size) {
    std::vector<Lifetime> lives;
    std::vector<size_t> owners;
    for (size_t i = 0; i < plan.targets.size(); ++i) {
        const PlannedTarget& target = plan.targets[i];
        if (target.desc.own && target.first >= 0) owned_.push_back({i, target.desc.own});
        if (target.desc.own) continue;
        const gpu::TextureDesc desc = texture_desc(target.desc, frame_size);
        if (target.history) histories_.push_back({target.name, desc});
        if (target.first < 0 || target.history) continue;
        lives.push_back({desc, target.first, target.last});
        owners.push_back(i);
    }
    const std::vector<size_t> shared = share_textures(lives);
    slots_.resize(shared.empty() ? 0 : *std::ranges::max_element(shared) + 1);
    std::vector<NamedDesc> wanted(slots_.size());
    std::vector<int> starts(slots_.size(), -1);
    numbers_.assign(plan.targets.size(), kNone);
    for (size_t i = 0; i < lives.size(); ++i) {
        const size_t slot = numbers_[owners[i]] = shared[i];
        if (starts[slot] < 0) wanted[slot] = {lives[i].desc, plan.targets[owners[i]].name};
        if (lives[i].first < starts[slot]) continue;
        starts[slot] = lives[i].first;
        slots_[slot].last_target = owners[i];
    }
    size_t next = slots_.size();
    for (size_t i = 0; i < plan.targets.size(); ++i)
        if (plan.targets[i].history) numbers_[i] = next++;
    return wanted;
}

const GraphTextures::History* GraphTextures::history(size_t target) const {
    const size_t number = numbers_[target];
    return number == kNone || number < slots_.size() ? nullptr : &histories_[number - slots_.size()];
}

const gpu::Texture* GraphTextures::current(size_t target) const {
    if (const History* pair = history(target)) return &pair->textures[pair->now];
    if (numbers_[target] != kNone) return &slots_[numbers_[target]].texture;
    const auto own = std::ranges::find(owned_, target, &Owned::target);
    return own == owned_.end() ? nullptr : own->texture();
}

const gpu::Texture* GraphTextures::previous(size_t target) const {
    const History* pair = history(target);
    return pair != nullptr && pair->frames > 1 ? &pair->textures[1 - pair->now] : nullptr;
}

bool GraphTextures::survives(size_t target) const {
    const size_t number = numbers_[target];
    return number < slots_.size() ? slots_[number].last_target == target : current(target) != nullptr;
}

void GraphTextures::next_frame(bool drop) {
    for (History& history : histories_) {
        history.now = 1 - history.now;
        history.frames = drop ? 1 : std::min(history.frames + 1, 2);
    }
}

size_t GraphTextures::memory() const {
    size_t bytes = 0;
    for (const Slot& slot : slots_) bytes += texture_bytes(slot.texture.desc());
    for (const History& history : histories_) bytes += 2 * texture_bytes(history.desc);
    return bytes;
}

}  // namespace tyndall
