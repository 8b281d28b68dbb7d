// Untrusted text: shown on one line, and carried through JSON.
#include "framework/staff/grade/strangers_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace relief::grade {
namespace {

TEST(StrangersText, IsShownWithoutControlAndBidiCharacters) {
    EXPECT_EQ(printable("plain \xc3\xbc \xe6\x97\xa5 \xf0\x9f\x99\x82"),
              "plain \xc3\xbc \xe6\x97\xa5 \xf0\x9f\x99\x82");
    EXPECT_EQ(printable("a\n\x1b[31m\x7f"), "a\\x0a\\x1b[31m\\x7f");
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m"),
              "\\xc2\\x9b31m")
        << "a control character in two bytes";
    EXPECT_EQ(printable("3 \xe2\x80\xae"
                        "01\xe2\x81\xa6\xd8\x9c"),
              "3 \\u202e01\\u2066\\u061c");
    EXPECT_EQ(printable_lines("a\n\tb\r\xe2\x80\xa8", 100), "a\n\tb\\x0d\\u2028");
}

TEST(StrangersText, IsUtf8ForAnyBytes) {
    EXPECT_EQ(printable("m\xfcller"), "m\\xfcller");
    EXPECT_EQ(printable("\xc0\xaf \xed\xa0\x80 \xf5 \xe2\x82"), "\\xc0\\xaf \\xed\\xa0\\x80 \\xf5 \\xe2\\x82");
    EXPECT_EQ(printable("12345\xc3\xbc", 6), "12345...") << "a character was cut in two";
    EXPECT_EQ(printable(std::string(1000, 'x')).size(), 203u);
}

TEST(StrangersText, ComposesAccentedLetters) {
    EXPECT_EQ(composed("Zoe\u0308 Nguye\u0302\u0303n"), "Zo\u00eb Nguy\u1ec5n") << "Annex 15: composed twice";
    EXPECT_EQ(composed("\u212bke"), "\u00c5ke") << "a sign for a letter is the letter";
    EXPECT_EQ(composed("\ufb01"), "\ufb01") << "a ligature stays: names that look alike are not all the same";
    EXPECT_EQ(composed("m\xfcller"), "m\xfcller") << "not UTF-8";
    EXPECT_EQ(composed(std::string("\u0301\0e\u0301", 6)), std::string("\u0301\0e\u0301", 6));
    EXPECT_EQ(composed("jane"), "jane");
}

TEST(StrangersText, RoundTripsThroughJson) {
    std::string all;
    for (int i = 0; i < 256; ++i) all += char(i);
    for (const std::string& bytes : {std::string("m\xfcller"), std::string("m\xc3\xbcller"), all,
                                     std::string("\xef\x9f\xbc private"), std::string("\xef\x9f"), std::string()}) {
        const std::string text = nlohmann::json(utf8_of_bytes(bytes)).dump();  // throws if the text is not UTF-8
        EXPECT_EQ(bytes_of_utf8(nlohmann::json::parse(text).get<std::string>()), bytes);
    }
    EXPECT_EQ(utf8_of_bytes("m\xc3\xbcller"), "m\xc3\xbcller");
}

}  // namespace
}  // namespace relief::grade
