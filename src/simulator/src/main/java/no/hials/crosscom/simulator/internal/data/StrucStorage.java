package no.hials.crosscom.simulator.internal.data;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;

/** A structure. */
final class StrucStorage extends Storage {
  private final Type.Struc type;
  private final Storage[] parts;

  StrucStorage(Type.Struc type, Storage[] parts) {
    this.type = type;
    this.parts = parts;
  }

  @Override
  Type.Struc type() {
    return type;
  }

  /** Returns the parts in the order of the components of the type. */
  List<Storage> parts() {
    return List.of(parts);
  }

  @Override
  long bytes() {
    return type.bytes();
  }

  @Override
  public boolean initialised() {
    for (Storage part : parts) {
      if (part.initialised()) {
        return true;
      }
    }
    return false;
  }

  @Override
  public KrlValue value() throws RefusedException {
    List<KrlStruct.Field> fields = new ArrayList<>(parts.length);
    for (int i = 0; i < parts.length; i++) {
      // only initialised components are printed (docs/reference/krl-values.md#structures)
      if (parts[i].initialised()) {
        String name = type.components().get(i).name();
        if (parts[i] instanceof ArrayStorage array) {
          array.addFields(name, fields);
        } else {
          boolean isText = parts[i] instanceof TextStorage;
          fields.add(new KrlStruct.Field(isText ? name + "[]" : name, parts[i].value()));
        }
      }
    }
    return new KrlStruct(type.name(), fields);
  }

  @Override
  Storage assign(KrlValue value) throws RefusedException {
    Storage result = this;
    for (KrlStruct.Field field : type.check(value).fields()) {
      VariablePath path = VariablePath.parse(field.name());
      result =
          result.changeComponent(
              path.first().name(), component -> component.write(path, field.value()));
    }
    return result;
  }

  @Override
  Storage takeOver(Storage others) {
    if (!(others instanceof StrucStorage struc)) {
      return this;
    }
    Storage[] changed = parts.clone();
    for (int i = 0; i < struc.parts.length; i++) {
      Integer own = type.positions().get(Scope.key(struc.type.components().get(i).name()));
      if (own != null) {
        changed[own] = parts[own].takeOver(struc.parts[i]);
      }
    }
    return new StrucStorage(type, changed);
  }

  @Override
  KrlValue rounded(KrlValue value) throws RefusedException {
    if (!(value instanceof KrlStruct given)) {
      return value;
    }
    KrlStruct struct = type.ofItsKind(given);
    List<KrlStruct.Field> fields = new ArrayList<>(struct.fields().size());
    for (KrlStruct.Field field : struct.fields()) {
      VariablePath path = VariablePath.parse(field.name());
      Storage part = component(path.first().name()).read(path);
      fields.add(new KrlStruct.Field(field.name(), part.rounded(field.value())));
    }
    return new KrlStruct(struct.typeName(), fields);
  }

  private int position(String name) throws RefusedException {
    Integer position = type.positions().get(name);
    if (position == null) {
      throw new RefusedException(Refusal.UNKNOWN_COMPONENT, type.name() + " has no ." + name);
    }
    return position;
  }

  @Override
  Storage component(String name) throws RefusedException {
    return parts[position(name)];
  }

  @Override
  Storage changeComponent(String name, Change change) throws RefusedException {
    int position = position(name);
    Storage part = change.apply(parts[position]);
    if (part == parts[position]) {
      return this;
    }
    Storage[] changed = parts.clone();
    changed[position] = part;
    return new StrucStorage(type, changed);
  }
}
