package no.hials.crosscom.web.internal.teach;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.web.internal.socket.CommandException;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.BulletList;
import org.commonmark.node.Code;
import org.commonmark.node.Document;
import org.commonmark.node.Emphasis;
import org.commonmark.node.FencedCodeBlock;
import org.commonmark.node.HardLineBreak;
import org.commonmark.node.Heading;
import org.commonmark.node.Image;
import org.commonmark.node.IndentedCodeBlock;
import org.commonmark.node.Link;
import org.commonmark.node.ListItem;
import org.commonmark.node.Node;
import org.commonmark.node.OrderedList;
import org.commonmark.node.Paragraph;
import org.commonmark.node.SoftLineBreak;
import org.commonmark.node.StrongEmphasis;
import org.commonmark.node.Text;
import org.commonmark.parser.Parser;

/** The lessons of the tutorial, which the build puts into the jar, as trees that the page draws. */
final class Lessons {
  private static final String FOLDER = "lesson/";

  /** The first line of the index that names a lesson, and a link to another lesson. */
  private static final Pattern ENTRY =
      Pattern.compile("\\[(\\d+ [^]]+)]\\((\\d\\d-[a-z-]+)\\.md\\)");

  private static final Pattern LINK = Pattern.compile("(\\d\\d-[a-z-]+)\\.md(#.*)?");

  private Lessons() {}

  /** A lesson: the name of its file without the ending, and its title. */
  private record Lesson(String name, String title) {}

  private static List<Lesson> all() throws IOException {
    Matcher entries = ENTRY.matcher(file("index"));
    return entries.results().map(it -> new Lesson(it.group(2), it.group(1))).toList();
  }

  private static String file(String name) throws IOException {
    try (InputStream file = Lessons.class.getResourceAsStream(FOLDER + name + ".md")) {
      if (file == null) {
        throw new IOException("there is no lesson " + name + " in this build");
      }
      return new String(file.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  /** Adds the names and titles of all lessons. */
  static void list(ArrayNode list) throws IOException {
    for (Lesson lesson : all()) {
      list.addObject().put("name", lesson.name()).put("title", lesson.title());
    }
  }

  /** Adds the text of a lesson: nodes with a kind, and a text or children. */
  static void show(String name, ArrayNode nodes) throws IOException {
    if (all().stream().noneMatch(lesson -> lesson.name().equals(name))) {
      throw new CommandException("there is no such lesson");
    }
    Parser.builder().build().parse(file(name)).accept(new TreeWriter(nodes));
  }

  /** Writes nodes as JSON: only the kinds that the page knows. */
  private static final class TreeWriter extends AbstractVisitor {
    private ArrayNode nodes;

    TreeWriter(ArrayNode nodes) {
      this.nodes = nodes;
    }

    private ObjectNode add(String kind, Node node) {
      ObjectNode added = nodes.addObject().put("kind", kind);
      ArrayNode outer = nodes;
      nodes = added.putArray("children");
      visitChildren(node);
      nodes = outer;
      return added;
    }

    private void addText(String kind, String text) {
      nodes.addObject().put("kind", kind).put("text", text);
    }

    @Override
    public void visit(Document node) {
      visitChildren(node);
    }

    @Override
    public void visit(Heading node) {
      add("h" + Math.min(node.getLevel() + 1, 4), node);
    }

    @Override
    public void visit(Paragraph node) {
      add("p", node);
    }

    @Override
    public void visit(BulletList node) {
      add("ul", node);
    }

    @Override
    public void visit(OrderedList node) {
      add("ol", node);
    }

    @Override
    public void visit(ListItem node) {
      add("li", node);
    }

    @Override
    public void visit(Emphasis node) {
      add("em", node);
    }

    @Override
    public void visit(StrongEmphasis node) {
      add("strong", node);
    }

    @Override
    public void visit(Image node) {
      visitChildren(node); // the description of the picture
    }

    /** Keeps only links to lessons, since the page has no links to other places. */
    @Override
    public void visit(Link node) {
      Matcher lesson = LINK.matcher(node.getDestination());
      if (lesson.matches()) {
        add("lesson", node).put("name", lesson.group(1));
      } else {
        visitChildren(node);
      }
    }

    @Override
    public void visit(FencedCodeBlock node) {
      addText("pre", node.getLiteral());
    }

    @Override
    public void visit(IndentedCodeBlock node) {
      addText("pre", node.getLiteral());
    }

    @Override
    public void visit(Code node) {
      addText("code", node.getLiteral());
    }

    @Override
    public void visit(Text node) {
      addText("text", node.getLiteral());
    }

    @Override
    public void visit(SoftLineBreak node) {
      addText("text", " ");
    }

    @Override
    public void visit(HardLineBreak node) {
      addText("text", " ");
    }
  }
}
