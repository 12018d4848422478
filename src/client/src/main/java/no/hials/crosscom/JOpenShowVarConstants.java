package no.hials.crosscom;

/**
 * Paths of the files of the original's programs.
 *
 * @deprecated kept for programs of version 0.1; nothing here uses these files
 */
@Deprecated
public interface JOpenShowVarConstants {
  /** The list of variables. */
  String FILELOCATION_VAR_LIST = "Resources//Var_list.txt";

  /** The address of the robot. */
  String FILELOCATION_ROBOT_IP = "Resources//Robot_IP.txt";
}
