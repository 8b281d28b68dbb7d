// Places in a shared buffer or texture for parts that come and go from frame to frame.
#pragma once

#include <map>
#include <set>
#include <vector>

namespace relief {

/// Gives each key a place, from 0 to capacity() - 1, which it keeps as long as it is wanted. `Value` is kept with it.
template <class Key, class Value>
class Slots {
public:
    struct Slot {
        int place = 0;
        Value value{};
    };

    int capacity() const { return capacity_; }
    /// Drops all slots.
    void reset(int capacity) { slots_.clear(), capacity_ = capacity; }
    /// Drops the slots of all keys that are not wanted, and gives each new key the lowest free place, in the order of
    /// keys. Returns the new keys. Precondition: at most capacity() keys are wanted.
    std::vector<Key> keep(const std::set<Key>& wanted) {
        std::erase_if(slots_, [&](const auto& slot) { return !wanted.contains(slot.first); });
        std::vector<bool> taken(size_t(capacity_), false);
        for (const auto& [key, slot] : slots_) taken[size_t(slot.place)] = true;
        std::vector<Key> fresh;
        for (int next = 0; const Key& key : wanted) {
            if (slots_.contains(key)) continue;
            while (taken[size_t(next)]) ++next;
            slots_[key].place = next++;
            fresh.push_back(key);
        }
        return fresh;
    }

    /// Throws std::out_of_range if the key has no slot.
    Slot& at(const Key& key) { return slots_.at(key); }
    const Slot& at(const Key& key) const { return slots_.at(key); }
    /// All keys with their slots, in the order of keys.
    auto begin() { return slots_.begin(); }
    auto end() { return slots_.end(); }

private:
    std::map<Key, Slot> slots_;
    int capacity_ = 0;
};

}  // namespace relief
