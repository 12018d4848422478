/**
 * Forward and inverse kinematics of six-axis KUKA robots.
 *
 * <p>{@link no.hials.crosscom.kinematics.RobotModel} is read from a file, so another robot needs no
 * class. {@link no.hials.crosscom.kinematics.Frames} computes with frames.
 */
@NullMarked
package no.hials.crosscom.kinematics;

import org.jspecify.annotations.NullMarked;
