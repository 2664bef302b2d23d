/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace psmks::test
{
/** Whether a text contains all of the words: `EXPECT_TRUE(says(message, {"key", "value"}))`. */
inline testing::AssertionResult says(const std::string& text,
                                     std::initializer_list<std::string> words)
{
  for (const std::string& word : words)
    if (text.find(word) == std::string::npos)
      return testing::AssertionFailure() << '"' << text << "\" does not say \"" << word << '"';
  return testing::AssertionSuccess() << '"' << text << '"';
}
}  // namespace psmks::test
