// Pages and tables of the reports.
#include "report/page.hpp"

#include "cob/files.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

namespace cob::report {
namespace {

// RFC 4648, section 10.
TEST(Base64, TestVectorsOfTheStandard) {
    const char* rows[][2] = {{"", ""},
                             {"f", "Zg=="},
                             {"fo", "Zm8="},
                             {"foo", "Zm9v"},
                             {"foob", "Zm9vYg=="},
                             {"fooba", "Zm9vYmE="},
                             {"foobar", "Zm9vYmFy"}};
    for (const auto& row : rows) EXPECT_EQ(base64(row[0]), row[1]);
    EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

TEST(Table, CellsThatNeedQuotesAreQuoted) {
    const Table table{{"claim", "where"}, {{"a, b", "say \"c\""}, {"plain", ""}}};
    EXPECT_EQ(table.csv(), "claim,where\n\"a, b\",\"say \"\"c\"\"\"\nplain,\n");
    EXPECT_EQ(table.text(), "claim  where\na, b   say \"c\"\nplain  \n");
}

TEST(Page, IsSelfContainedAndEscaped) {
    const test::TemporaryFolder folder;
    const std::string picture = folder / "picture.png";
    write_file(picture, "foobar");
    Page page("a < b");
    page.picture(picture, "six \"bytes\"");
    page.picture(picture + ".missing", "none");
    const std::string html = page.html();
    EXPECT_NE(html.find("<title>a &lt; b</title>"), std::string::npos);
    EXPECT_NE(html.find("src=\"data:image/png;base64,Zm9vYmFy\""), std::string::npos);
    EXPECT_NE(html.find("none: no picture"), std::string::npos);
    EXPECT_EQ(html.find("http"), std::string::npos);
}

}  // namespace
}  // namespace cob::report
