/**
 * The kinematics of six-axis KUKA robots: where the flange is for six axis angles, and back.
 *
 * <p>{@link no.hials.crosscom.kinematics.RobotModel} is a robot and is read from a file, so that
 * another model needs no class. The values, {@link no.hials.crosscom.kinematics.Axes} and {@link
 * no.hials.crosscom.kinematics.Frame}, are records of finite numbers in the units of KRL: mm and
 * degrees.
 */
@NullMarked
package no.hials.crosscom.kinematics;

import org.jspecify.annotations.NullMarked;
