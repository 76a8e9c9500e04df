#include "sim/effects/catalogue.h"

namespace nao::sim {

// One line per effect; each is defined in the file of the same name.
EffectType coulombFriction();
EffectType viscousFriction();
EffectType stribeckFriction();
EffectType loadFriction();
EffectType frictionAsymmetry();
EffectType torqueLimit();
EffectType voltageSag();
EffectType thermalDerating();
EffectType kpError();
EffectType kdError();
EffectType servoDeadband();
EffectType motorInertia();
EffectType backlash();
EffectType gearCompliance();
EffectType encoderOffset();
EffectType encoderQuantum();
EffectType encoderJitter();
EffectType sensorDelay();
EffectType droppedSamples();
EffectType sampleJitter();
EffectType commandLatency();
EffectType commandHold();
EffectType rateLimit();
EffectType commandFilter();
EffectType linkMass();
EffectType linkCom();
EffectType payload();
EffectType gravityScale();
EffectType linearDamping();
EffectType angularDamping();
EffectType groundFriction();
EffectType groundCompliance();
EffectType groundTilt();
EffectType imuBias();
EffectType imuScale();
EffectType imuMisalignment();
EffectType imuLowPass();
EffectType imuNoise();
EffectType fsrGain();
EffectType fsrThreshold();
EffectType processNoise();
EffectType jointZero();
EffectType startPose();
EffectType floorFriction();
EffectType massSpread();
EffectType integralGain();
EffectType jointStop();
EffectType cogging();
EffectType cableSpring();
EffectType torqueBias();

const EffectCatalogue& standardEffects() {
  static const EffectCatalogue catalogue = [] {
    EffectCatalogue all;
    all.add(coulombFriction());
    all.add(viscousFriction());
    all.add(stribeckFriction());
    all.add(loadFriction());
    all.add(frictionAsymmetry());
    all.add(torqueLimit());
    all.add(voltageSag());
    all.add(thermalDerating());
    all.add(kpError());
    all.add(kdError());
    all.add(servoDeadband());
    all.add(motorInertia());
    all.add(backlash());
    all.add(gearCompliance());
    all.add(encoderOffset());
    all.add(encoderQuantum());
    all.add(encoderJitter());
    all.add(sensorDelay());
    all.add(droppedSamples());
    all.add(sampleJitter());
    all.add(commandLatency());
    all.add(commandHold());
    all.add(rateLimit());
    all.add(commandFilter());
    all.add(linkMass());
    all.add(linkCom());
    all.add(payload());
    all.add(gravityScale());
    all.add(linearDamping());
    all.add(angularDamping());
    all.add(groundFriction());
    all.add(groundCompliance());
    all.add(groundTilt());
    all.add(imuBias());
    all.add(imuScale());
    all.add(imuMisalignment());
    all.add(imuLowPass());
    all.add(imuNoise());
    all.add(fsrGain());
    all.add(fsrThreshold());
    all.add(processNoise());
    all.add(jointZero());
    all.add(startPose());
    all.add(floorFriction());
    all.add(massSpread());
    all.add(torqueBias());
    all.add(cableSpring());
    all.add(cogging());
    all.add(jointStop());
    all.add(integralGain());
    return all;
  }();
  return catalogue;
}

}  // namespace nao::sim
