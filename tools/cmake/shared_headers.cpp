// The precompiled headers of many targets belong to those of this file; it has nothing of its own.
