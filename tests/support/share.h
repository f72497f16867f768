// How much of a long random test is run: all of it, or a tenth where the sanitizers make everything ten times
// slower.
#pragma once

namespace regista::testing {

#ifdef REGISTA_TEST_SHARE
constexpr int share_of(int count) { return count / REGISTA_TEST_SHARE; }
#else
constexpr int share_of(int count) { return count; }
#endif

}  // namespace regista::testing
