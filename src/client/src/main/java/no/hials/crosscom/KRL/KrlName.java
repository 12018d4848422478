package no.hials.crosscom.KRL;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Says what a component of a record, or a constant of an enum, is called on the controller, where
 * that is not its Java name. See {@link KRLRecord}.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target({ElementType.RECORD_COMPONENT, ElementType.FIELD})
public @interface KrlName {
  /**
   * Gives the name.
   *
   * @return a KRL name, such as {@code SEAM_NO}, without {@code []} or {@code #}; case does not
   *     matter
   */
  String value();
}
