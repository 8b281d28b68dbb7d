// A file descriptor of the system, closed by its owner.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <string_view>

namespace relief {

class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        close();
        number_ = other.release();
        return *this;
    }
    operator int() const { return number_; }
    /// Returns false if the system reports an error.
    bool close() { return number_ < 0 || ::close(release()) == 0; }

private:
    int release() {
        const int number = number_;
        number_ = -1;
        return number;
    }
    int number_;
};

/// Writes all bytes, and continues when signals interrupt. Returns false on failure; errno has the reason.
bool write_all(int descriptor, std::string_view bytes);
/// Reads `size` bytes. Returns false on failure, or when the end comes first.
bool read_all(int descriptor, void* bytes, size_t size);

}  // namespace relief
