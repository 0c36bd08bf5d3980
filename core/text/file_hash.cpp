#include "core/text/file_hash.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <span>
#include <string_view>
#include <system_error>
#include <vector>

namespace hedr {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPiece = std::size_t{1} << 20;  // bytes

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
struct FreeDigest {
    void operator()(EVP_MD_CTX* digest) const { EVP_MD_CTX_free(digest); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;
using Digest = std::unique_ptr<EVP_MD_CTX, FreeDigest>;

std::string hexadecimal(std::span<const unsigned char> bytes) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (const unsigned char byte : bytes) {
        text += kDigits[byte >> 4U];
        text += kDigits[byte & 15U];
    }
    return text;
}

Result<File> opened(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found)
        return fail(ErrorCode::kFileMissing, file.string());
    // A pipe or a device may never end.
    if (!fs::is_regular_file(status))
        return fail(ErrorCode::kFileUnreadable, file.string(), "not a regular file");
    if (File in{std::fopen(file.c_str(), "rb")}) return in;
    return fail(ErrorCode::kFileUnreadable, file.string(), std::generic_category().message(errno));
}

Result<void> feed(EVP_MD_CTX* digest, std::FILE* in, const fs::path& file,
                  const HashProgress& progress) {
    std::error_code ignored;
    const auto size = static_cast<double>(fs::file_size(file, ignored));
    std::vector<unsigned char> piece(kPiece);
    double done = 0.0;
    while (const std::size_t got = std::fread(piece.data(), 1, piece.size(), in)) {
        EVP_DigestUpdate(digest, piece.data(), got);
        done += static_cast<double>(got);
        if (progress && !progress(std::min(1.0, done / size)))
            return fail(ErrorCode::kCanceled, file.string());
    }
    if (std::ferror(in) == 0) return {};
    return fail(ErrorCode::kFileUnreadable, file.string(), std::generic_category().message(errno));
}

}  // namespace

Result<std::string> fileHash(const fs::path& file, const HashProgress& progress) {
    const auto in = opened(file);
    if (!in) return tl::make_unexpected(in.error());
    const Digest digest(EVP_MD_CTX_new());
    EVP_DigestInit_ex(digest.get(), EVP_sha256(), nullptr);
    if (const auto fed = feed(digest.get(), in->get(), file, progress); !fed)
        return tl::make_unexpected(fed.error());
    std::array<unsigned char, EVP_MAX_MD_SIZE> hash{};
    unsigned int length = 0;
    EVP_DigestFinal_ex(digest.get(), hash.data(), &length);
    return hexadecimal(std::span(hash).first(length));
}

}  // namespace hedr
