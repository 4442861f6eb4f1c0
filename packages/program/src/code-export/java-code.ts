import { SILENT_WORDS } from "@corridor/protocol";
import { chainOf, commentName, type CodeContent } from "./code-text.ts";

export function javaCode({ name, lines, address, command }: CodeContent): string {
  const rules = chainOf(lines, { indent: "  ", depth: 2, call: "drive", hasBraces: true });
  return `// ${commentName(name)}
// Choose Remote on the robot's page. Then: ${command}
import java.io.IOException;
import java.net.URI;
import java.net.http.*;
import java.time.Duration;
import java.util.UUID;
import java.util.regex.*;

public class Rules {
  static final String ROBOT = ${address};

  static void decide(double front, double right, double back, double left) throws Exception {
${rules}
  }

  // The calls of the robot's service. The robot ends "forward" and "reverse" itself, as soon as one
  // of the conditions at the end of the call is true: then another line decides.
  static final HttpClient HTTP = HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
  static String now;
  static String ask(String path, String order) throws Exception {
    String[] parts = ROBOT.replace("/r/", "/api/v1/robots/").split("#");
    // With the key, a command that arrives twice runs once.
    var request = HttpRequest.newBuilder(URI.create(parts[0] + path)).timeout(Duration.ofSeconds(35))
        .headers("Authorization", "Bearer " + parts[1], "Content-Type", "application/json")
        .header("Idempotency-Key", UUID.randomUUID().toString());
    if (order != null) request.POST(HttpRequest.BodyPublishers.ofString("{" + order + "}"));
    for (int attempt = 0; attempt < 40; attempt++) {
      try {
        var answer = HTTP.send(request.build(), HttpResponse.BodyHandlers.ofString());
        int status = answer.statusCode();
        if (status < 300) return answer.body();
        if (status != 429 && status < 500) throw new IllegalStateException(field(answer.body(), "detail"));
      } catch (IOException lost) { /* a lost connection */ }
      Thread.sleep((long) (1000 * Math.random()));
    }
    throw new IllegalStateException("The robot's service does not answer.");
  }
  static String run(String order) throws Exception {
    String record = ask("/commands", order);
    while (field(record, "state").matches("accepted|delivered|started"))
      record = ask("/commands/" + field(record, "seq") + "?wait=25", null);
    return record;
  }
  static void drive(String line, String action, String... until) throws Exception {
    System.out.println(line + ": " + action);
    if (action.equals("stop")) throw new IllegalStateException(line + " stops the robot. No reading changes after that.");
    String order = "\\"action\\":\\"" + action + "\\",\\"ttl\\":60000", ends = "{\\"goal\\":true}";
    for (String text : until.length == 0 ? until : until[0].split(" or "))
      ends += ",{" + text.replaceAll("(\\\\w+) (\\\\S+) (.+)", "\\"sensor\\":\\"$1\\",\\"is\\":\\"$2\\",\\"than\\":$3}")
          .replaceAll("right [+]?(-?) (.+)}", "\\"right\\",\\"plus\\":$1$2}");
    if (action.matches("forward|reverse")) order += ",\\"until\\":[" + ends + "]";
    String record = run(order), state = field(record, "state"), reason = field(record, "reason");
    if (state.equals("collided") && field(record, "pose").equals(field(now, "pose")))
      throw new IllegalStateException(line + " drives against a wall. No reading changes after that.");
    // After a lost connection, the robot stands on its path: decide again.
    if (!state.matches("completed|collided") && !reason.contains("${SILENT_WORDS}"))
      throw new IllegalStateException(reason.equals("null") ? state : reason);
  }

  static String field(String json, String name) {
    var value = Pattern.compile("\\"" + name + "\\":\\\\s*(\\\\{[^}]*|\\"(\\\\\\\\.|[^\\"\\\\\\\\])*|[^,}]*)").matcher(json);
    return value.find() ? value.group(1).replaceAll("^\\"|\\\\\\\\(?=\\")", "") : json;
  }
  static double number(String name) { return Double.parseDouble(field(now, name)); }
  public static void main(String[] words) throws Exception {
    // A robot that cannot go back to its start drives from where it is.
    try { run("\\"action\\":\\"reset\\""); } catch (IllegalStateException refused) { }
    try {
      while (!field(now = ask("/sensors?wait=10", null), "goalReached").equals("true"))
        decide(number("front"), number("right"), number("back"), number("left"));
      System.out.println("The robot has reached the goal.");
    } catch (IllegalStateException end) { System.err.println(end.getMessage()); System.exit(1); }
  }
}
`;
}
