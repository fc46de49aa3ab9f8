// The precompiled headers of all modules belong to the target of this file; it has nothing of its own.
