// A library, but no module.

extern "C" int something_else() {
    return 1;
}
