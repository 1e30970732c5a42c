// Keys by what is printed on them, in layouts as xkeyboard-config 2.35 has them.
#include "platform/events.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace coaster::platform {
namespace keyboard_test {

// The places of a US keyboard, row by row.
constexpr std::string_view kPlaces = "`1234567890-=QWERTYUIOP[]\\ASDFGHJKL;'ZXCVBNM,./";

// What they type without modifiers, in the same order; "" for a dead key.
using Row = std::vector<std::string>;
const Row kGerman{"",  "1", "2", "3", "4", "5", "6", "7", "8", "9", "0", "ß", "",  "q", "w", "e",
                  "r", "t", "z", "u", "i", "o", "p", "ü", "+", "#", "a", "s", "d", "f", "g", "h",
                  "j", "k", "l", "ö", "ä", "y", "x", "c", "v", "b", "n", "m", ",", ".", "-"};
const Row kFrench{"²", "&", "é", "\"", "'", "(", "-", "è", "_", "ç", "à", ")", "=", "a", "z", "e",
                  "r", "t", "y", "u",  "i", "o", "p", "",  "$", "*", "q", "s", "d", "f", "g", "h",
                  "j", "k", "l", "m",  "ù", "w", "x", "c", "v", "b", "n", ",", ";", ":", "!"};
const Row kSpanish{"º", "1", "2", "3", "4", "5", "6", "7", "8", "9", "0", "'", "¡", "q", "w", "e",
                   "r", "t", "y", "u", "i", "o", "p", "",  "+", "ç", "a", "s", "d", "f", "g", "h",
                   "j", "k", "l", "ñ", "",  "z", "x", "c", "v", "b", "n", "m", ",", ".", "-"};
const Row kRussian{"ё", "1", "2", "3", "4", "5", "6", "7", "8", "9",  "0", "-", "=", "й", "ц", "у",
                   "к", "е", "н", "г", "ш", "щ", "з", "х", "ъ", "\\", "ф", "ы", "в", "а", "п", "р",
                   "о", "л", "д", "ж", "э", "я", "ч", "с", "м", "и",  "т", "ь", "б", "ю", "."};
const Row kGreek{"`", "1", "2", "3", "4", "5", "6", "7", "8", "9",  "0", "-", "=", ";", "ς", "ε",
                 "ρ", "τ", "υ", "θ", "ι", "ο", "π", "[", "]", "\\", "α", "σ", "δ", "φ", "γ", "η",
                 "ξ", "κ", "λ", "",  "'", "ζ", "χ", "ψ", "ω", "β",  "ν", "μ", ",", ".", "/"};
const Row kDvorak{"`", "1", "2", "3", "4", "5", "6", "7", "8", "9",  "0", "[", "]", "'", ",", ".",
                  "p", "y", "f", "g", "c", "r", "l", "/", "=", "\\", "a", "o", "e", "u", "i", "d",
                  "h", "t", "n", "s", "-", ";", "q", "j", "k", "x",  "b", "m", "w", "v", "z"};
const Row kTurkish{"\"", "1", "2", "3", "4", "5", "6", "7", "8", "9", "0", "*", "-", "q", "w", "e",
                   "r",  "t", "y", "u", "ı", "o", "p", "ğ", "ü", ",", "a", "s", "d", "f", "g", "h",
                   "j",  "k", "l", "ş", "i", "z", "x", "c", "v", "b", "n", "m", "ö", "ç", "."};
const Row kHebrew{";", "1", "2", "3", "4", "5", "6", "7", "8", "9",  "0", "-", "=", "/", "'", "ק",
                  "ר", "א", "ט", "ו", "ן", "ם", "פ", "]", "[", "\\", "ש", "ד", "ג", "כ", "ע", "י",
                  "ח", "ל", "ך", "ף", ",", "ז", "ס", "ב", "ה", "נ",  "מ", "צ", "ת", "ץ", "."};

// Returns the keys of all places as text: the character of the key, a blank for Key::unknown.
std::string keys_of(const Row& row) {
  EXPECT_EQ(row.size(), kPlaces.size());
  bool other_script = false;
  for (std::size_t i = 0; i < row.size(); ++i)
    if (kPlaces[i] >= 'A' && kPlaces[i] <= 'Z') other_script = other_script || is_other_script(row[i]);
  std::string keys;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const Key key = key_at(Key{kPlaces[i]}, row[i], other_script);
    keys += key == Key::unknown ? ' ' : static_cast<char>(key);
  }
  return keys;
}

TEST(keyboard, letters_are_the_printed_ones_and_digits_have_their_row) {
  //                             `1234567890-=QWERTYUIOP[]\ASDFGHJKL;'ZXCVBNM,./
  EXPECT_EQ(keys_of(kGerman), " 1234567890- QWERTZUIOP[]\\ASDFGHJKL;'YXCVBNM,.-") << "a dead key has no shortcut";
  EXPECT_EQ(keys_of(kFrench), "`1234567890-=AZERTYUIOP ]\\QSDFGHJKLM'WXCVBN,;./");
  EXPECT_EQ(keys_of(kSpanish), "`1234567890'=QWERTYUIOP ]\\ASDFGHJKL; ZXCVBNM,.-");
  EXPECT_EQ(keys_of(kDvorak), "`1234567890[]',.PYFGCRL/=\\AOEUIDHTNS-;QJKXBMWVZ");
  EXPECT_EQ(keys_of(kTurkish), "`1234567890--QWERTYUIOP[],ASDFGHJKL;IZXCVBNM,..");
}

TEST(keyboard, other_scripts_have_the_places_of_a_us_keyboard) {
  EXPECT_EQ(keys_of(kRussian), "`1234567890-=QWERTYUIOP[]\\ASDFGHJKL;'ZXCVBNM,..");
  EXPECT_EQ(keys_of(kGreek), "`1234567890-=QWERTYUIOP[]\\ASDFGHJKL 'ZXCVBNM,./");
  EXPECT_EQ(keys_of(kHebrew), ";1234567890-=QWERTYUIOP][\\ASDFGHJKL;,ZXCVBNM,..");
}

TEST(keyboard, keys_without_print_have_their_place) {
  for (const Key key : {Key::space, Key::enter, Key::keypad_enter, Key::keypad_1, Key::f12, Key::left})
    EXPECT_EQ(key_at(key, "1", false), key);
  EXPECT_EQ(key_at(Key{161}, "<", false), Key::unknown) << "beside the left Shift";
  EXPECT_EQ(key_at(Key{161}, "\\", false), Key::backslash);
  EXPECT_EQ(key_at(Key{-1}, "", false), Key::unknown);
  EXPECT_EQ(key_at(Key::w, "é", false), Key::unknown) << "bépo, whose W is elsewhere";
  EXPECT_EQ(key_at(Key::y, "Z", false), Key::z) << "with Shift or Caps Lock";
}

TEST(keyboard, scripts_are_told_by_letters) {
  for (const char* const latin : {"q", "é", "ß", "ı", "ạ", "ẞ", ";", "€", "→", ""})
    EXPECT_FALSE(is_other_script(latin));
  for (const char* const other : {"α", "й", "ש", "ض", "ก", "あ", "ㅂ", "Ա", "ა"}) EXPECT_TRUE(is_other_script(other));
}

}  // namespace keyboard_test
}  // namespace coaster::platform
