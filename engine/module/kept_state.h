#pragma once
/// What a module's users authored, kept as JSON while the module is away.

#include <memory>

#include "module/registration.h"

namespace tyndall {

/// Values of one module's components and settings in all worlds. Fields that the present version of a type does not
/// know are kept and come back with a version that does; so do components whose type has gone.
class KeptState {
 public:
    KeptState();
    ~KeptState();
    /// Reads everything of this registration, before it is dropped.
    void save(const ModuleHost& host, const Registration& registration);
    /// Puts back what the newly installed registration has types for. Missing fields have their defaults; values that
    /// no longer fit are logged and left at their defaults.
    void restore(ModuleHost& host, const Registration& registration);

 private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

}  // namespace tyndall
