package program;

import java.util.HashMap;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.KRL.structs.KRLAxis;
import no.hials.crosscom.KRL.structs.KRLFrame;
import no.hials.crosscom.KRL.structs.KRLStruct;
import no.hials.crosscom.variables.Variable;

/** Derives classes from those of the library. */
public class OwnClasses {
  static class Place extends KRLFrame {
    int parsed;

    Place(String name) {
      super(name, new String[] {"X", "Y", "Z", "A", "B", "C"});
    }

    void shift(double by) {
      struct.put("X", struct.get("X") + by);
    }

    HashMap<String, Double> fields() {
      return struct;
    }

    @Override
    protected void setValueFromString(String text) {
      parsed++;
      super.setValueFromString(text);
    }
  }

  static class Axes extends KRLAxis {
    Axes(String name) {
      super(name, new String[] {"A1", "A2"});
      struct.put("A2", -90.0);
    }
  }

  static class Load extends KRLStruct {
    private final HashMap<String, Double> map = new HashMap<String, Double>();

    Load(String name) {
      super(name, new String[] {"M"});
    }

    @Override
    public HashMap<String, Double> getValue() {
      return map;
    }

    @Override
    public void setValue(String field, String value) {
      map.put(field, Double.parseDouble(value));
    }
  }

  static class Text extends Variable<String> {
    Text(String name) {
      super(7, name, "Text", 5L);
    }

    String before() {
      return value;
    }

    void set(String text) {
      setValue(text);
    }
  }

  static class Word extends KRLVariable {
    private String word = "";

    Word(String name) {
      super(name);
    }

    @Override
    public Object getValue() {
      return word;
    }

    @Override
    public String getStringValue() {
      return word;
    }

    @Override
    protected void setValueFromString(String text) {
      word = text;
    }
  }

  public static String run(String host, int port) throws Exception {
    StringBuilder out = new StringBuilder();
    CrossComClient client = new CrossComClient(host, port);

    Place place = new Place("MYFRAME");
    client.readVariable(place);
    place.shift(0.5);
    out.append(place.getX()).append(' ').append(place.fields().size()).append('\n');
    client.writeVariable(place);
    out.append(place.parsed).append('\n');
    client.readVariable(place);
    out.append(place.fields()).append('\n');

    out.append(new Axes("MYAXIS").getStringValue()).append('\n');

    Load load = new Load("MYLOAD");
    load.setValue("M", "2.5");
    out.append(load.getStringValue()).append('\n');

    Text text = new Text("T");
    out.append(text.before()).append(' ').append(text.getDataType());
    text.set("abc");
    out.append(' ').append(text.getValue()).append(' ').append(text.getId()).append('\n');
    text.update("def", 6);
    out.append(text.getValue()).append(text.getReadTime()).append('\n');

    Word word = new Word("$MODE_OP");
    client.readVariable(word);
    out.append(word.getValue()).append('\n');

    client.close();
    return out.toString();
  }
}
