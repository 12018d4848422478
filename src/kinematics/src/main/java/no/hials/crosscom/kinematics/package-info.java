/**
 * Forward and inverse kinematics of six-axis KUKA robots.
 *
 * <p>{@link no.hials.crosscom.kinematics.RobotModel} is read from a file, so another robot needs no
 * class. The values, {@link no.hials.crosscom.kinematics.Axis} and {@link
 * no.hials.crosscom.kinematics.Frame}, are records of finite numbers in the units of KRL: mm and
 * degrees.
 */
@NullMarked
package no.hials.crosscom.kinematics;

import org.jspecify.annotations.NullMarked;
