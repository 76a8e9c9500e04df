#include "naoqi_api/wire/frame.h"

#include <gtest/gtest.h>

namespace nao::wire {
namespace {

Message sample() {
  Message message;
  message.id = 0x01020304;
  message.type = MessageType::Call;
  message.flags = 2;
  message.address = {5, 6, 7};
  message.payload = {9, 8, 7};
  return message;
}

TEST(Frame, HasTheKnownLayout) {
  const Bytes expected = {0x42, 0xDE, 0xAD, 0x42, 4, 3, 2, 1, 3, 0, 0, 0, 0, 0, 1, 2,
                          5,    0,    0,    0,    6, 0, 0, 0, 7, 0, 0, 0, 9, 8, 7};
  EXPECT_EQ(encodeFrame(sample()), expected);
}

TEST(FrameReader, HalfAMessageInNothingOut) {
  const Bytes frame = encodeFrame(sample());
  FrameReader reader;
  for (std::size_t i = 0; i + 1 < frame.size(); ++i) {
    reader.push(&frame[i], 1);
    EXPECT_FALSE(reader.next());
    EXPECT_GT(reader.bytesHeld(), 0U);
  }
  reader.push(&frame.back(), 1);
  const auto message = reader.next();
  ASSERT_TRUE(message);
  EXPECT_EQ(message->id, 0x01020304U);
  EXPECT_EQ(message->flags, 2);
  EXPECT_EQ(message->address.action, 7U);
  EXPECT_EQ(message->payload, (Bytes{9, 8, 7}));
  EXPECT_EQ(reader.bytesHeld(), 0U);
}

TEST(FrameReader, CutsManyMessagesFromOnePiece) {
  const Bytes frame = encodeFrame(sample());
  Bytes stream;
  for (int i = 0; i < 3; ++i) stream.insert(stream.end(), frame.begin(), frame.end());
  FrameReader reader;
  reader.push(stream.data(), stream.size() - 1);
  EXPECT_TRUE(reader.next());
  EXPECT_TRUE(reader.next());
  EXPECT_FALSE(reader.next());
  reader.push(&stream.back(), 1);
  EXPECT_TRUE(reader.next());
}

TEST(FrameReader, BreaksAtTheFirstWrongByteOfTheMagic) {
  FrameReader reader;
  const Bytes start = {0x42, 0xDE, 0x00};
  reader.push(start.data(), start.size());
  EXPECT_FALSE(reader.next());
  EXPECT_TRUE(reader.isBroken());
}

TEST(FrameReader, BreaksWhenAMessageIsLargerThanAllowed) {
  Message message = sample();
  message.payload.resize(101);
  const Bytes frame = encodeFrame(message);
  FrameReader strict;
  strict.setMaxPayload(100);
  strict.push(frame.data(), kHeaderSize);  // the header is enough to know
  EXPECT_FALSE(strict.next());
  EXPECT_TRUE(strict.isBroken());
  FrameReader enough;
  enough.setMaxPayload(101);
  enough.push(frame.data(), frame.size());
  EXPECT_TRUE(enough.next());
}

TEST(FrameReader, KeepsNothingOnceBroken) {
  FrameReader reader;
  const Bytes garbage(100, 0xFF);
  reader.push(garbage.data(), garbage.size());
  EXPECT_FALSE(reader.next());
  const Bytes frame = encodeFrame(sample());
  reader.push(frame.data(), frame.size());
  EXPECT_FALSE(reader.next());
}

}  // namespace
}  // namespace nao::wire
