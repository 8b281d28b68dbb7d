// Reports of faults are found in a task's output, and each has its fault and its place.
#include "framework/course/check/printed.h"

#include <gtest/gtest.h>

namespace relief::check {
namespace {

/// As GCC 12 prints it for a course in /home/a.
std::string address_report(const std::string& kind, const std::string& more = "") {
    return "=================================================================\n"
           "==367==ERROR: AddressSanitizer: " +
           kind + " on address 0x602000000024 at pc 0x55d9a1265d9e\n" + more +
           "    #0 0x55d9a1265d9d in f /home/a/framework/core/base/mesh.h:9\n"
           "    #1 0x55d9a1265d9d in relief::corner(int) /home/a/labs/05_tangent_basis/task.cpp:41\n"
           "    #2 0x7f746d845249 in g /home/a/labs/05_tangent_basis/task.cpp:90\n"
           "SUMMARY: AddressSanitizer: " +
           kind + "\n";
}

TEST(PrintedText, NamesTheFaultAndTheLineOfTheTask) {
    struct Case {
        std::string text, fault;
    };
    const std::string place = "labs/05_tangent_basis/task.cpp:41";
    for (const Case& one : {
             Case{address_report("heap-buffer-overflow"), "reads or writes outside of an array"},
             Case{address_report("heap-use-after-free"), "uses memory that was freed"},
             Case{address_report("stack-overflow"), "has no stack left: does a function call itself without end?"},
             Case{address_report("FPE"), "divides an integer by zero"},
             Case{address_report("SEGV", "==367==Hint: address points to the zero page.\n"), "uses a null pointer"},
             Case{"/home/a/" + place + ":24: runtime error: index 5 out of bounds for type 'int [3]'\n" +
                      address_report("stack-buffer-overflow"),
                  "index 5 out of bounds for type 'int [3]'"},
             Case{"/usr/include/c++/12/bits/stl_vector.h:1123: reference std::vector<int>::operator[](size_type): "
                  "Assertion '__n < this->size()' failed.\n" +
                      address_report("ABRT"),
                  "violates what the C++ library demands: __n < this->size()"},
         }) {
        const Printed printed = read_printed(one.text);
        EXPECT_EQ(printed.fault, one.fault);
        EXPECT_EQ(printed.place, place) << one.text;
        EXPECT_EQ(printed.text, "") << one.text;
    }
}

TEST(PrintedText, ThatTheTaskPrintsStays) {
    const Printed own = read_printed("weight 0.5\nan Assertion '");
    EXPECT_EQ(own.text, "weight 0.5\nan Assertion '");
    EXPECT_EQ(own.fault + own.place, "");
    EXPECT_EQ(read_printed("before\n" + address_report("SEGV")).text, "before\n");
}

TEST(PrintedText, OfAProcessThatWasStoppedHasAPlaceAndNoFault) {
    const Printed stopped = read_printed("AddressSanitizer:DEADLYSIGNAL\n" + address_report("ABRT"));
    EXPECT_EQ(stopped.fault, "");
    EXPECT_EQ(stopped.place, "labs/05_tangent_basis/task.cpp:41");
}

TEST(PrintedText, TellsTheLimitOfMemory) {
    EXPECT_TRUE(read_printed("==3180==AddressSanitizer: hard rss limit exhausted (2000Mb vs 2005Mb)\n").has_no_memory);
    EXPECT_FALSE(read_printed(address_report("SEGV")).has_no_memory);
}

TEST(PrintedText, EndingAnywhereIsRead) {
    const std::string text = address_report("heap-buffer-overflow");
    for (size_t size = 0; size <= text.size(); ++size) read_printed(text.substr(0, size));
}

}  // namespace
}  // namespace relief::check
