// NAOqi 1.x's places and names. Nothing here includes alptr.h: its programs often do not.

#include <almemoryproxy.h>
#include <alproxy.h>
#include <gtest/gtest.h>

#include <type_traits>

namespace {

struct Base {
  virtual ~Base() = default;
  int number = 1;
};
struct Derived : Base {};

int numberOf(const boost::shared_ptr<Base>& object) { return object->number; }
AL::ALPtr<Base> make() { return boost::shared_ptr<Base>(new Derived); }

TEST(Flat, AProxyIsHeldByAnAlPtr) {
  AL::ALPtr<AL::ALMemoryProxy> none;
  EXPECT_FALSE(none);
  none = AL::ALPtr<AL::ALMemoryProxy>();
  EXPECT_EQ(none.get(), nullptr);
}

TEST(Flat, AnAlPtrAndASharedPointerAreOne) {
  const AL::ALPtr<Derived> derived(new Derived);
  EXPECT_EQ(numberOf(derived), 1);
  EXPECT_EQ(derived.use_count(), 1);
  const boost::shared_ptr<Base> made = make();
  EXPECT_TRUE(boost::dynamic_pointer_cast<Derived>(made));
}

TEST(Flat, AWeakPointerGivesAnAlPtrBack) {
  AL::ALPtr<Base> object(new Base);
  const AL::ALWeakPtr<Base> watched = object;
  const AL::ALPtr<Base> held = watched.lock();
  EXPECT_EQ(held, object);
}

}  // namespace
