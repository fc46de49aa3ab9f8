// libtyndall is made of its floors; a shared library needs a source of its own.
