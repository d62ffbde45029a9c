// Asks for a function that no runtime has.
__attribute__((import_module("ros2wasm"), import_name("teleport"))) int teleport(void);

int main(void) { return teleport(); }
