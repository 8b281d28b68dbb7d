// A file descriptor of the system, closed by its owner. Each operating system has its own implementation, in the file
// that implements system.h.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace relief {

constexpr int standard_output = 1, standard_error = 2;

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
    bool close();

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
/// Reads `size` bytes, or fewer when the end comes first, and continues when signals interrupt. Returns their number,
/// or nothing on failure; errno has the reason.
std::optional<size_t> read_up_to(int descriptor, void* bytes, size_t size);
/// Reads `size` bytes. Returns false on failure, or when the end comes first.
inline bool read_all(int descriptor, void* bytes, size_t size) { return read_up_to(descriptor, bytes, size) == size; }

}  // namespace relief
