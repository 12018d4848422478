package no.hials.crosscom.lang;

import java.util.Map;
import no.hials.crosscom.lang.internal.PackedList;
import no.hials.crosscom.lang.internal.TreeBytes;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ContentContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.NamedContext;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;

/** Builds the tree of the lines from {@code DEFDAT} to {@code ENDDAT}. */
final class DataListBuilder {
  private final Errors errors;
  private final ExpressionBuilder expressions;
  private final DeclarationBuilder declarationBuilder;
  private final Position position;
  private final PackedList<Declaration> declarations;
  private @Nullable String name;
  private boolean isPublic;
  private boolean suspect;

  DataListBuilder(Line line, TreeBytes tree, Errors errors) {
    this.errors = errors;
    declarations = new PackedList<>(tree, Declaration.class);
    expressions = new ExpressionBuilder(errors);
    declarationBuilder = new DeclarationBuilder(errors, expressions, true);
    position = errors.at(line.first());
    ContentContext content = line.parse(errors);
    if (content != null) {
      name = declarationBuilder.declared(content.dataListBegin().name());
      isPublic = content.dataListBegin().PUBLIC() != null;
    }
  }

  /** Adds a line. */
  void add(Line line) {
    if (StatementWords.isUnsupported(line)) {
      ErrorWords.reportUnsupported(line, errors);
      return;
    }
    errors.beginLine();
    // Two names can only be a declaration here, so DECL is optional before any type (assumed).
    if (line.isUnknown() && !ErrorWords.isName(line.second())) {
      ErrorWords.reportUnknown(line, errors);
      suspect |= line.isOneWord();
      return;
    }
    ContentContext content = line.parse(errors);
    if (content == null) {
      return;
    }
    Declaration declaration = declarationBuilder.build(content, line.comment());
    if (declaration == null) {
      declaration = initialValue(line, content);
    }
    if (declaration != null && errors.damage() == null) {
      declarations.append(declaration);
    }
  }

  private @Nullable Declaration initialValue(Line line, ContentContext content) {
    NamedContext named = content.named();
    if (named == null || named.steps() == null) {
      errors.add(
          line.first(), "a data list contains only declarations, found " + line.first().getText());
      return null;
    }
    return new Declaration.InitialValue(
        expressions.at(named),
        expressions.variable(named.name(), named.steps()),
        expressions.build(named.expression()),
        line.comment());
  }

  /**
   * Ends the data list.
   *
   * @param found {@code ENDDAT}, or the token found in its place
   * @return null if the first line contains an error
   */
  @Nullable DataList finish(Token found, Map<String, String> headers) {
    if (found.getType() != KrlGrammarParser.ENDDAT && !suspect) {
      errors.note(errors.at(found), "expected ENDDAT, found " + ErrorWords.found(found));
    }
    return name == null
        ? null
        : new DataList(position, name, isPublic, headers, declarations.trim());
  }
}
