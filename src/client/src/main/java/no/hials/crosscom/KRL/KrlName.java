package no.hials.crosscom.KRL;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Sets the name on the controller of a record component or an enum constant, if it differs from the
 * Java name. See {@link KRLRecord}.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target({ElementType.RECORD_COMPONENT, ElementType.FIELD})
public @interface KrlName {
  /**
   * Returns the KRL name, such as {@code SEAM_NO}, without {@code []} or {@code #}; case is
   * ignored.
   */
  String value();
}
