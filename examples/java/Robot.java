import java.io.IOException;
import java.net.ProxySelector;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.time.Duration;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import java.util.UUID;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Follow the right-hand wall through a maze.
 *
 * <p>Run it with the robot's address, as the page shows it under Remote (keep the quotes; where it cannot
 * be copied, a code gets one: see the README of the examples):
 *
 * <pre>java Robot.java "http://localhost:8080/r/ID#KEY"</pre>
 *
 * <p>It needs Java 17 or newer and nothing else. The robot keeps its right hand on the wall: where
 * there is an opening on the right it goes in, else straight on, else it turns left.
 */
public class Robot {
  /** One cell of the maze is 100 cm wide. */
  private static final int CELL = 100;

  /** Farther than this, and there is no wall in the next cell. */
  private static final int OPEN = 60;

  private static final Pattern ADDRESS =
      Pattern.compile("(https?://[^/?#\\s@]+)/r/([A-Za-z0-9_-]{1,64})#([A-Za-z0-9_-]{8,64})");

  /** How long the service may stay silent until the program gives up. */
  private static final long PATIENCE_MS = 30_000;

  private static final double FIRST_PAUSE_MS = 250;
  private static final double LONGEST_PAUSE_MS = 10_000;

  /** What the robot's owner sees of this program. */
  private static final String NAME = "Right wall";

  private static final int PROXY_WANTS_A_NAME = 407;
  private static final int TOO_MANY = 429;

  /** Something did not work; the text says what, and how to mend it. */
  public static class RobotException extends RuntimeException {
    RobotException(String sentence) {
      super(sentence);
    }
  }

  /** What the robot sees, in cm, and where it is. */
  public record View(double front, double right, double x, double y, boolean goalReached) {}

  private final String api;
  private final String key;

  // HTTP/1.1, because with the default Java offers an upgrade to HTTP/2 in every request, which
  // some proxies answer with an error. The proxy is the one of -Dhttps.proxyHost, if any.
  private final HttpClient http =
      HttpClient.newBuilder()
          .version(HttpClient.Version.HTTP_1_1)
          .connectTimeout(Duration.ofSeconds(10))
          .proxy(ProxySelector.getDefault())
          .build();

  public Robot(String address) {
    Matcher parts = ADDRESS.matcher(address.strip());
    if (!parts.matches()) {
      throw new RobotException(
          "This is not a robot's address. Copy the whole address from the page, and put it in"
              + " \"quotes\": the part after the # is the key.");
    }
    api = parts.group(1) + "/api/v1/robots/" + parts.group(2);
    key = parts.group(3);
  }

  /** Drives so many cm. Gives "completed", or "collided" if a wall was in the way. */
  public String forward(double distance) {
    return command("\"action\":\"move\",\"distance\":" + distance);
  }

  public String left() {
    return command("\"action\":\"left 90\"");
  }

  public String right() {
    return command("\"action\":\"right 90\"");
  }

  /** What the robot sees now, never from before the end of its last command. */
  public View look() {
    String seen = ask("GET", "/sensors?wait=10", null);
    return new View(
        number(seen, "front"),
        number(seen, "right"),
        number(seen, "x"),
        number(seen, "y"),
        field(seen, "goalReached", "(true|false)").equals("true"));
  }

  /** Sends a command, waits until it has ended, and gives how. */
  private String command(String fields) {
    String record = ask("POST", "/commands", fields);
    while (true) {
      String state = field(record, "state", "\"(\\w+)\"");
      switch (state) {
        case "completed", "collided" -> {
          return state;
        }
        case "cancelled", "superseded", "expired" ->
            throw new RobotException(
                "The command was " + state + ": " + field(record, "reason", "(null|\"[^\"]*\")"));
        default -> record = ask("GET", "/commands/" + (long) number(record, "seq") + "?wait=10", null);
      }
    }
  }

  /** One request to the service, tried again when the network or the service has a bad moment. */
  private String ask(String method, String path, String fields) {
    // The key makes a retry safe: a command that arrives twice is done once.
    String idempotencyKey = UUID.randomUUID().toString();
    long began = System.nanoTime();
    for (int tries = 0; ; tries++) {
      String trouble;
      try {
        HttpResponse<String> answer = http.send(request(method, path, fields, idempotencyKey, age(began)), BodyHandlers.ofString());
        int status = answer.statusCode();
        if (status >= 200 && status < 300) return answer.body();
        trouble = sentence(status, answer.body());
        if (status != TOO_MANY && status < 500) throw new RobotException(trouble);
      } catch (IOException error) {
        trouble = "The service does not answer: " + error;
      } catch (InterruptedException error) {
        throw new RobotException("Stopped by you.");
      }
      // Drawn by lot, so that a whole class does not come back in the same moment.
      double pause = Math.random() * Math.min(LONGEST_PAUSE_MS, FIRST_PAUSE_MS * Math.pow(2, tries));
      if (age(began) + pause > PATIENCE_MS) throw new RobotException(trouble);
      sleep((long) pause);
    }
  }

  private HttpRequest request(String method, String path, String fields, String idempotencyKey, long age) {
    HttpRequest.Builder request =
        HttpRequest.newBuilder(URI.create(api + path))
            .timeout(Duration.ofSeconds(20))
            .header("Authorization", "Bearer " + key)
            .header("Script-Name", NAME)
            .header("User-Agent", "Java-example");
    if (fields == null) return request.method(method, BodyPublishers.noBody()).build();
    // How old the wish is: one that comes late is not done late.
    String aged = age == 0 ? fields : fields + ",\"age\":" + age;
    return request
        .header("Content-Type", "application/json")
        .header("Idempotency-Key", idempotencyKey)
        .method(method, BodyPublishers.ofString("{" + aged + "}"))
        .build();
  }

  private static long age(long began) {
    return (System.nanoTime() - began) / 1_000_000;
  }

  private static void sleep(long milliseconds) {
    try {
      Thread.sleep(milliseconds);
    } catch (InterruptedException error) {
      throw new RobotException("Stopped by you.");
    }
  }

  /** The sentence in which the service says what is wrong. */
  private static String sentence(int status, String body) {
    Matcher detail = Pattern.compile("\"detail\":\\s*\"((?:[^\"\\\\]|\\\\.)*)\"").matcher(body);
    if (detail.find()) return detail.group(1).replace("\\\"", "\"");
    if (status == PROXY_WANTS_A_NAME) return "The network's proxy wants a name and a password.";
    return "The service answered with status " + status + ".";
  }

  // Java brings no reader of JSON along. In what the service answers each of these names comes once.

  private static double number(String json, String name) {
    return Double.parseDouble(field(json, name, "(-?[0-9.eE+-]+)"));
  }

  private static String field(String json, String name, String value) {
    Matcher found = Pattern.compile("\"" + name + "\":\\s*" + value).matcher(json);
    if (found.find()) return found.group(1);
    throw new RobotException("What answers at this address is not a robot's host.");
  }

  /** Goes on until the goal is reached, or so many different cells are visited. */
  private static void followRightWall(Robot robot, int untilCells, int mostMoves) {
    Set<String> visited = new HashSet<>();
    int moves = 0;
    while (true) {
      View view = robot.look();
      visited.add((int) (view.x / CELL) + "," + (int) (view.y / CELL));
      if (untilCells == 0 && view.goalReached) {
        say("Goal reached after %d moves.", moves);
        return;
      }
      if (untilCells > 0 && visited.size() >= untilCells) {
        say("%d cells visited after %d moves.", visited.size(), moves);
        return;
      }
      if (moves >= mostMoves) {
        throw new RobotException(
            "Not there after " + moves + " moves; " + visited.size() + " cells visited.");
      }
      String how;
      if (view.right > OPEN) {
        say("%.0f cm on the right: turn right and go", view.right);
        robot.right();
        how = robot.forward(CELL);
        moves++;
      } else if (view.front > OPEN) {
        say("%.0f cm ahead: go on", view.front);
        how = robot.forward(CELL);
        moves++;
      } else {
        say("Wall ahead and on the right: turn left");
        how = robot.left();
      }
      if (how.equals("collided")) say("Bumped into a wall!");
    }
  }

  private static void say(String sentence, Object... numbers) {
    System.out.println(String.format(Locale.ROOT, sentence, numbers));
  }

  /** A whole number of an option, which stands after its name. */
  private static int option(String[] arguments, String name, int otherwise) {
    for (int at = 1; at + 1 < arguments.length; at++) {
      if (arguments[at].equals(name)) return Integer.parseInt(arguments[at + 1]);
    }
    return otherwise;
  }

  public static void main(String[] arguments) {
    try {
      Robot robot = new Robot(arguments.length == 0 ? "" : arguments[0]);
      int untilCells = option(arguments, "--until-cells", 0);
      followRightWall(robot, untilCells, option(arguments, "--moves", 2000));
    } catch (RobotException | NumberFormatException error) {
      System.err.println(error.getMessage());
      System.exit(1);
    }
  }
}
