// SPEC section 7: manifest.json holds "a SHA-256 for each file".
#include "cob/manifest.hpp"

#include "cob/error.hpp"
#include "cob/files.hpp"
#include "golden/sha256.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

namespace cob {
namespace {

// Vectors of FIPS 180-4's example documents and of NIST's long message.
TEST(Sha256, PublishedVectors) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// Both ways to compute it, whatever the processor: lengths around the block's end, in parts that end anywhere.
TEST(Sha256, ProcessorsInstructionsAndPlainCodeAgree) {
    if (sha256_compress_of_processor() == nullptr) GTEST_SKIP() << "no such instructions here";
    std::string bytes(1000, '\0');
    for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<char>(k * 2654435761u >> 13);
    for (std::size_t size = 0; size <= bytes.size(); ++size) {
        const std::string_view whole(bytes.data(), size);
        Sha256 plain(sha256_compress), other(sha256_compress_of_processor());
        plain.update(whole);
        other.update(whole.substr(0, size / 3));
        other.update(whole.substr(size / 3));
        ASSERT_EQ(plain.finish(), other.finish()) << size;
    }
}

TEST(DescribeFile, ReadsInBlocksWhatSha256SeesWhole) {
    const test::TemporaryFolder folder;
    for (const std::size_t size : {0u, 1u, 55u, 56u, 63u, 64u, 65u, 262143u, 262144u, 262145u, 600000u}) {
        std::string bytes(size, '\0');
        for (std::size_t k = 0; k < size; ++k) bytes[k] = static_cast<char>(k * 2654435761u >> 13);
        write_file(folder / "file", bytes);
        const ManifestFile file = describe_file(folder / "file");
        EXPECT_EQ(file.bytes, size);
        EXPECT_EQ(file.sha256, sha256(bytes)) << size;
    }
}

TEST(Manifest, ReadsBackAndFindsChangedFiles) {
    const test::TemporaryFolder folder;
    write_file(folder / "boxes.csv", "box\n");
    Manifest manifest;
    manifest.parameters = {{"margin", "0.125"}, {"height", "1/3"}};
    manifest.counts = {{"boxes", 0}};
    manifest.files["boxes.csv"] = describe_file(folder / "boxes.csv");
    write_manifest(folder / "manifest.json", manifest);

    const Manifest again = read_manifest(folder / "manifest.json");
    EXPECT_EQ(again.parameters, manifest.parameters);
    EXPECT_EQ(again.counts, manifest.counts);
    EXPECT_NO_THROW(check_files(folder.path(), again));

    write_file(folder / "boxes.csv", "bix\n");
    EXPECT_THROW(check_files(folder.path(), again), InputError);
    write_file(folder / "boxes.csv", "boxes\n");
    EXPECT_THROW(check_files(folder.path(), again), InputError);
    std::remove((folder / "boxes.csv").c_str());
    EXPECT_THROW(check_files(folder.path(), again), InputError);
}

TEST(Manifest, RefusesWhatIsNone) {
    const test::TemporaryFolder folder;
    const std::string path = folder / "manifest.json";
    for (const char* text : {
             "",
             "{",
             "[]",
             "{}",
             R"({"format": 2, "parameters": {}, "counts": {}, "files": {}})",
             R"({"format": 1, "parameters": {}, "counts": {}})",
             R"({"format": 1, "parameters": {}, "counts": {"boxes": "many"}, "files": {}})",
             R"({"format": 1, "parameters": {}, "counts": {}, "files": {"../x": {"bytes": 0, "sha256": ""}}})",
         }) {
        write_file(path, text);
        EXPECT_THROW(read_manifest(path), InputError) << text;
    }
    EXPECT_THROW(read_manifest(folder / "none.json"), InputError);
}

}  // namespace
}  // namespace cob
