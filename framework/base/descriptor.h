// An open file or folder of the system, closed with its owner.
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

/// Writes everything, also when signals interrupt. False on failure; errno says why.
bool write_all(int descriptor, std::string_view bytes);
/// Reads so many bytes. False on failure, or where the end comes before.
bool read_all(int descriptor, void* bytes, size_t size);

}  // namespace relief
