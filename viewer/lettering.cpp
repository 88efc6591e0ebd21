#include "viewer/lettering.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace arris::viewer {
namespace {

// Strokes of the characters from '!' to '~': pairs of digits are x and y on a grid, y upwards with
// the base line at 2; a space lifts the pen; a pair alone is a dot.
constexpr std::array<std::string_view, 94> glyphs = {
    "0804 02",                           // !
    "0806 2826",                         // "
    "1713 3733 0646 0444",               // #
    "473818070615354443321203 2921",     // $
    "0818170708 3343423233 0248",        // %
    "4207182837260403122244",            // &
    "0806",                              // '
    "19070311",                          // (
    "09171301",                          // )
    "2723 0644 0446",                    // *
    "2723 0545",                         // +
    "1201",                              // ,
    "0535",                              // -
    "02",                                // .
    "0139",                              // /
    "183847433212030718",                // 0
    "071812 0222",                       // 1
    "07183847460242",                    // 2
    "07183847463515 354443321203",       // 3
    "32380444",                          // 4
    "480805354443321203",                // 5
    "473818070312324344351504",          // 6
    "084812",                            // 7
    "15060718384746351504031232434435",  // 8
    "031232434738180706153546",          // 9
    "05 02",                             // :
    "15 1201",                           // ;
    "380532",                            // <
    "0646 0444",                         // =
    "083502",                            // >
    "071838474624 22",                   // ?
    "343616144447381807031242",          // @
    "022842 1535",                       // A
    "02083847463505 3544433202",         // B
    "4738180703123243",                  // C
    "02082846442202",                    // D
    "48080242 0535",                     // E
    "480802 0535",                       // F
    "47381807031232434525",              // G
    "0802 4842 0545",                    // H
    "0802",                              // I
    "3833221203",                        // J
    "0802 4804 1542",                    // K
    "080242",                            // L
    "0208254842",                        // M
    "02084248",                          // N
    "183847433212030718",                // O
    "02083847463505",                    // P
    "183847433212030718 2442",           // Q
    "02083847463505 2542",               // R
    "473818070615354443321203",          // S
    "0848 2822",                         // T
    "080312324348",                      // U
    "082248",                            // V
    "0812263248",                        // W
    "0842 0248",                         // X
    "082548 2522",                       // Y
    "08480242",                          // Z
    "19090111",                          // [
    "0931",                              // backslash
    "09191101",                          // ]
    "062846",                            // ^
    "0141",                              // _
    "0817",                              // `
    "36160503122233 3632",               // a
    "0802 0516263533221203",             // b
    "3526160503122233",                  // c
    "3832 3526160503122233",             // d
    "043435261605031232",                // e
    "281712 0626",                       // f
    "3526160503122233 36312000",         // g
    "0802 0516263532",                   // h
    "0602 08",                           // i
    "161100 18",                         // j
    "0802 3603 1432",                    // k
    "080312",                            // l
    "0602 05162522 25364542",            // m
    "0602 0516263532",                   // n
    "162635332212030516",                // o
    "0600 0516263533221203",             // p
    "3630 3526160503122233",             // q
    "0602 051626",                       // r
    "3616051424332202",                  // s
    "181322 0626",                       // t
    "0603122233 3632",                   // u
    "062246",                            // v
    "0612253246",                        // w
    "0632 0236",                         // x
    "0622 4610",                         // y
    "06360232",                          // z
    "29181605141221",                    // {
    "0901",                              // |
    "09181625141201",                    // }
    "04152435",                          // ~
};

constexpr double space_width = 4, gap = 2, base_line = 2;

std::string_view glyph(char c) {
  if (c == ' ') return {};
  const bool known = c > ' ' && c <= '~';
  return glyphs[static_cast<std::size_t>((known ? c : '?') - '!')];
}

double advance(std::string_view strokes) {
  if (strokes.empty()) return space_width;
  int widest = 0;
  for (std::size_t i = 0; i < strokes.size(); i += 2) {
    if (strokes[i] == ' ') ++i;
    widest = std::max(widest, strokes[i] - '0');
  }
  return widest + gap;
}

}  // namespace

double text_width(const std::string& text, double unit) {
  double width = 0;
  for (const char c : text) width += advance(glyph(c));
  return unit * std::max(0.0, width - gap);
}

void draw_text(Ink& ink, const std::string& text, Pixel base, double unit, double pen) {
  for (const char c : text) {
    const std::string_view strokes = glyph(c);
    const auto point = [&](std::size_t i) {
      return Pixel{base.x + unit * (strokes[i] - '0'),
                   base.y - unit * (strokes[i + 1] - '0' - base_line)};
    };
    bool pen_down = false;
    for (std::size_t i = 0; i < strokes.size(); i += 2) {
      if (strokes[i] == ' ') {
        ++i;
        pen_down = false;
      }
      ink.stroke(point(pen_down ? i - 2 : i), point(i), pen);
      pen_down = true;
    }
    base.x += unit * advance(strokes);
  }
}

}  // namespace arris::viewer
