#include "interior_buffers.h"

namespace tyndall::translucency {

bool InteriorBuffers::update(const InteriorKey& key) {
    if (block_.name() != 0 && key == key_) return false;
    key_ = key;
    made_ = interior_block(key);
    block_ = gpu::Buffer(sizeof made_, &made_, "translucency.interior");
    return true;
}

void InteriorBuffers::bind(const gpu::Program& program) const {
    program.block("Interior", block_);
    paint_.bind(program);
}

}  // namespace tyndall::translucency
