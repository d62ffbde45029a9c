// Keys and signatures in minisign's format, whole and hostile. What minisign itself says of them:
// tests/e2e/pack/signature.test.ts.
#include "bundler/site/signature.hpp"

#include <gtest/gtest.h>

#include "bundler/io/base64.hpp"
#include "bundler/io/ed25519.hpp"

namespace ros2wasm {
namespace {

constexpr const char* kMessage = "{\"generator\":\"ros2wasm\"}\n";

std::string secret_text(const std::string& parameters, char seed, const std::string& check) {
  std::string key(32, seed);
  key += ed25519_public(key + std::string(32, '\0'));
  return "untrusted comment: of a test\n" + base64("Ed" + parameters + "12345678" + key + check) +
         "\n";
}

std::string without_password(char seed) {
  return secret_text(std::string("\0\0B2", 4) + std::string(48, '\0'), seed, std::string(32, '\0'));
}

SecretKey secret(char seed = 's') {
  auto key = read_secret_key(without_password(seed), "test.key", "");
  EXPECT_TRUE(key.ok());
  return std::move(key).value();
}

std::string code_of(const Diagnostics& errors) {
  return errors.front().code.text();
}

/// The code, or nothing when `text` is a signature of `message` by the key of `seed`.
std::string refused(const std::string& text, const std::string& message = kMessage,
                    char seed = 's') {
  const auto signature = read_signature(text, "site.json.minisig");
  if (!signature) return code_of(signature.errors());
  const auto checked = check_signature(*signature, public_key_of(secret(seed)), message);
  return checked.ok() ? "" : code_of(checked.errors());
}

TEST(SiteSignature, IsTheSameEachTimeAndFitsItsBytesKeyAndComment) {
  const std::string text = signature_text(secret(), kMessage, "version 2");
  EXPECT_EQ(text, signature_text(secret(), kMessage, "version 2"));
  EXPECT_EQ(refused(text), "");
  EXPECT_EQ(refused(text, std::string(kMessage) + " "), "R2W0657");
  EXPECT_EQ(refused(text, kMessage, 't'), "R2W0657") << "another key with the same id";
  std::string other = text;
  other.replace(other.find("version 2"), 9, "version 3");
  EXPECT_EQ(refused(other), "R2W0657");
}

TEST(SiteSignature, AnotherKeysIdIsNamed) {
  const auto signature = read_signature(signature_text(secret(), kMessage, ""), "s");
  PublicKey key = public_key_of(secret());
  key.id = "abcdefgh";
  const auto checked = check_signature(*signature, key, kMessage);
  ASSERT_FALSE(checked.ok());
  EXPECT_EQ(checked.errors().front().why.front(),
            "its signature names the key 3837363534333231, given was the key 6867666564636261");
}

TEST(SiteSignature, AKeysIdIsWrittenAsMinisignWritesIt) {
  EXPECT_EQ(key_id_text("\x14\x3e\xee\x20\xd4\x79\x44\x0b"), "B4479D420EE3E14");
  EXPECT_EQ(key_id_text(std::string(8, '\0')), "0");
}

// Guarantee, hostile input: a signature or key that was cut, changed in any letter, or made to lie
// about its size or cost is refused
TEST(SiteSignature, NoLetterOfItCanBeChangedOrLeftOut) {
  const std::string text = signature_text(secret(), kMessage, "version 2");
  const std::size_t signed_from = text.find('\n');
  for (std::size_t i = signed_from; i < text.size(); ++i) {
    std::string changed = text;
    changed[i] = changed[i] == 'B' ? 'C' : 'B';
    // The last line's end may be missing; anything in its place is another line.
    EXPECT_NE(refused(changed), "") << i;
    if (i + 1 < text.size()) {
      EXPECT_NE(refused(text.substr(0, i)), "") << i;
    }
  }
  EXPECT_EQ(refused(text.substr(0, text.size() - 1)), "") << "a last line without its end";
}

TEST(SiteSignature, WhatIsNoneIsRefused) {
  const std::string text = signature_text(secret(), kMessage, "ok");
  for (const std::string& bad :
       {std::string(), std::string("\n\n\n\n"), std::string(100'000, 'A'), text + text,
        text + "more\n", std::string(20'000, '\n'), "x" + text}) {
    EXPECT_EQ(refused(bad), "R2W0656");
  }
  const std::string control = signature_text(secret(), kMessage, "red \x1b[31m");
  EXPECT_EQ(refused(control), "R2W0656");
  std::string old_kind = text;
  const std::size_t line = text.find('\n') + 1;
  std::string bytes = *base64_read(text.substr(line, text.find('\n', line) - line));
  bytes[1] = 'd';
  old_kind.replace(line, text.find('\n', line) - line, base64(bytes));
  EXPECT_EQ(refused(old_kind), "R2W0656");
}

TEST(SiteSignature, APublicKeyIsReadFromItsFileOrItsLine) {
  const PublicKey key = public_key_of(secret());
  const std::string file = public_key_text(key);
  const std::string line = file.substr(file.find('\n') + 1);
  for (const std::string& text : {file, line, line.substr(0, line.size() - 1)}) {
    const auto read = read_public_key(text, "minisign.pub");
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read->id, key.id);
    EXPECT_EQ(read->key, key.key);
  }
  for (const std::string& text : {std::string(), std::string("RW"), without_password('s'),
                                  line.substr(0, 52), std::string(100'000, 'R')}) {
    const auto read = read_public_key(text, "minisign.pub");
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(code_of(read.errors()), "R2W0655");
  }
}

TEST(SigningKey, OnesThatLieOrWantTooMuchAreRefusedBeforeAnythingIsComputed) {
  const auto refusal_of = [](const std::string& text) {
    const auto key = read_secret_key(text, "test.key", "password");
    return key.ok() ? std::string() : code_of(key.errors());
  };
  EXPECT_EQ(refusal_of(without_password('s')), "");
  const std::string salt(32, 'n');
  const std::string little("\0\0\1\0\0\0\0\0", 8);
  const std::string much(8, '\x7f');
  EXPECT_EQ(refusal_of(secret_text("ScB2" + salt + little + much, 's', std::string(32, 'c'))),
            "R2W0658");
  EXPECT_EQ(refusal_of(secret_text("ScB2" + salt + much + little, 's', std::string(32, 'c'))),
            "R2W0658");
  const std::string memory("\0\0\0\1\0\0\0\0", 8);
  EXPECT_EQ(refusal_of(secret_text("ScB2" + salt + little + memory, 's', std::string(32, 'c'))),
            "R2W0659");
  const std::string none = std::string("\0\0B2", 4) + std::string(48, '\0');
  EXPECT_EQ(refusal_of(secret_text(none, 's', std::string(32, 'c'))), "R2W0658") << "wrong check";
  EXPECT_EQ(refusal_of(secret_text("XxB2" + std::string(48, '\0'), 's', std::string(32, '\0'))),
            "R2W0658");
  EXPECT_EQ(refusal_of(public_key_text(public_key_of(secret()))), "R2W0658");
}

TEST(SigningKey, ItsCommentIsOneLine) {
  EXPECT_TRUE(check_trusted_comment("Caf\xc3\xa9, 2026").ok());
  for (const std::string& bad : {std::string("a\nb"), std::string(8'001, 'a')})
    EXPECT_EQ(code_of(check_trusted_comment(bad).errors()), "R2W0902");
}

}  // namespace
}  // namespace ros2wasm
