package no.hials.crosscom.KRL.structs;

import java.util.AbstractMap;
import java.util.AbstractSet;
import java.util.Collection;
import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/**
 * The fields of a structure as a {@link HashMap}, which programs of the original read and change.
 *
 * <p>It is a view without entries of its own: each method is that of {@link AbstractMap} on the
 * fields.
 */
final class FieldMap extends HashMap<String, Double> {
  private static final long serialVersionUID = 1L;

  private final transient View fields;

  FieldMap(NumberStruct owner) {
    fields = new View(owner);
  }

  private static final class View extends AbstractMap<String, Double> {
    private final NumberStruct owner;

    View(NumberStruct owner) {
      this.owner = owner;
    }

    @Override
    public @Nullable Double put(String field, Double value) {
      Double before = get(field);
      owner.put(field, value);
      return before;
    }

    @Override
    public Set<Map.Entry<String, Double>> entrySet() {
      return new AbstractSet<>() {
        @Override
        public int size() {
          return owner.copyOfFields().size();
        }

        @Override
        public Iterator<Map.Entry<String, Double>> iterator() {
          Iterator<Map.Entry<String, Double>> copy = owner.copyOfFields().entrySet().iterator();
          return new Iterator<>() {
            @Override
            public boolean hasNext() {
              return copy.hasNext();
            }

            @Override
            public Map.Entry<String, Double> next() {
              return new Field(owner, copy.next());
            }
          };
        }
      };
    }
  }

  private static final class Field extends AbstractMap.SimpleEntry<String, Double> {
    private static final long serialVersionUID = 1L;

    private final transient NumberStruct owner;

    Field(NumberStruct owner, Map.Entry<String, Double> entry) {
      super(entry);
      this.owner = owner;
    }

    @Override
    public Double setValue(Double value) {
      owner.put(getKey(), value);
      return super.setValue(value);
    }
  }

  @Override
  public int size() {
    return fields.size();
  }

  @Override
  public boolean isEmpty() {
    return fields.isEmpty();
  }

  @Override
  public @Nullable Double get(Object key) {
    return fields.get(key);
  }

  @Override
  public boolean containsKey(Object key) {
    return fields.containsKey(key);
  }

  @Override
  public boolean containsValue(Object value) {
    return fields.containsValue(value);
  }

  @Override
  public @Nullable Double put(String key, Double value) {
    return fields.put(key, value);
  }

  @Override
  public void putAll(Map<? extends String, ? extends Double> map) {
    fields.putAll(map);
  }

  @Override
  public @Nullable Double remove(Object key) {
    return fields.remove(key);
  }

  @Override
  public void clear() {
    fields.clear();
  }

  @Override
  public Set<String> keySet() {
    return fields.keySet();
  }

  @Override
  public Collection<Double> values() {
    return fields.values();
  }

  @Override
  public Set<Map.Entry<String, Double>> entrySet() {
    return fields.entrySet();
  }

  @Override
  public Double getOrDefault(Object key, Double other) {
    return fields.getOrDefault(key, other);
  }

  @Override
  public @Nullable Double putIfAbsent(String key, Double value) {
    return fields.putIfAbsent(key, value);
  }

  @Override
  public boolean remove(Object key, Object value) {
    return fields.remove(key, value);
  }

  @Override
  public boolean replace(String key, Double oldValue, Double newValue) {
    return fields.replace(key, oldValue, newValue);
  }

  @Override
  public @Nullable Double replace(String key, Double value) {
    return fields.replace(key, value);
  }

  @Override
  public @Nullable Double computeIfAbsent(
      String key, Function<? super String, ? extends @Nullable Double> function) {
    return fields.computeIfAbsent(key, function);
  }

  @Override
  public @Nullable Double computeIfPresent(
      String key, BiFunction<? super String, ? super Double, ? extends @Nullable Double> function) {
    return fields.computeIfPresent(key, function);
  }

  @Override
  public @Nullable Double compute(
      String key,
      BiFunction<? super String, ? super @Nullable Double, ? extends @Nullable Double> function) {
    return fields.compute(key, function);
  }

  @Override
  public @Nullable Double merge(
      String key,
      Double value,
      BiFunction<? super Double, ? super Double, ? extends @Nullable Double> function) {
    return fields.merge(key, value, function);
  }

  @Override
  public void forEach(BiConsumer<? super String, ? super Double> action) {
    fields.forEach(action);
  }

  @Override
  public void replaceAll(BiFunction<? super String, ? super Double, ? extends Double> function) {
    fields.replaceAll(function);
  }

  /** Returns a copy that later changes do not affect. */
  @Override
  public Object clone() {
    return new LinkedHashMap<>(fields);
  }

  private Object writeReplace() {
    return new LinkedHashMap<>(fields);
  }
}
