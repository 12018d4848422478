package no.hials.crosscom.control;

import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.value.Axis;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * Computes the axis velocities for a velocity of the flange by damped least squares: {@code w = Jᵀ
 * (J Jᵀ + λ² I)⁻¹ v}. Near a singularity, where the exact solution has unbounded axis velocities,
 * the result is less exact instead. A joint velocity law can use it in place of the controller's
 * inverse kinematics.
 *
 * <p>Lengths are in units of 10 mm, so that they weigh about as much as degrees on an arm of human
 * size. Not thread-safe; it creates one object per call.
 */
public final class DampedLeastSquares {
  private static final int SIX = 6;
  private static final int LENGTHS = 3;
  private static final double MM = 0.1;

  private final RobotModel model;
  private final double squaredDamping;
  private final DMatrixRMaj jacobian = new DMatrixRMaj(SIX, SIX);
  private final DMatrixRMaj square = new DMatrixRMaj(SIX, SIX);
  private final DMatrixRMaj twist = new DMatrixRMaj(SIX, 1);
  private final DMatrixRMaj solution = new DMatrixRMaj(SIX, 1);
  private final DMatrixRMaj velocities = new DMatrixRMaj(SIX, 1);

  /**
   * Creates a solver.
   *
   * @param model the robot
   * @param damping λ, more than 0; 0.05 to 0.5 are usual
   */
  public DampedLeastSquares(RobotModel model, double damping) {
    Checks.positive("damping", damping);
    this.model = model;
    this.squaredDamping = damping * damping;
  }

  /**
   * Returns the axis velocities.
   *
   * @param axes the axis positions
   * @param flange the velocity of the flange, along and about the axes of {@code $ROBROOT}
   * @return degrees/s
   */
  public Axis velocity(Axis axes, Twist flange) {
    double[][] rows = model.jacobian(axes);
    for (int row = 0; row < SIX; row++) {
      for (int column = 0; column < SIX; column++) {
        jacobian.set(row, column, rows[row][column] * (row < LENGTHS ? MM : 1));
      }
    }
    twist.data[0] = flange.x() * MM;
    twist.data[1] = flange.y() * MM;
    twist.data[2] = flange.z() * MM;
    twist.data[3] = flange.aboutX();
    twist.data[4] = flange.aboutY();
    twist.data[5] = flange.aboutZ();
    CommonOps_DDRM.multTransB(jacobian, jacobian, square);
    for (int i = 0; i < SIX; i++) {
      square.add(i, i, squaredDamping);
    }
    CommonOps_DDRM.solve(square, twist, solution); // positive definite due to the damping
    CommonOps_DDRM.multTransA(jacobian, solution, velocities);
    return Axis.of(velocities.data);
  }
}
