#include <alerror/alerror.h>
#include <alvalue/alvalue.h>

int main() {
  try {
    const float number = AL::ALValue("text");
    return number > 0 ? 1 : 2;
  } catch (const AL::ALError&) {
    return 0;
  }
}
