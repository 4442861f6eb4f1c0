// Follow the right-hand wall through a maze.
//
// Run it with the robot's address, as the page shows it under Remote (keep the quotes):
//
//     dotnet run Robot.cs "http://localhost:8080/r/ID#KEY"
//
// It needs .NET 10 or newer and nothing else; with an older one, put it into a project of
// `dotnet new console` as Program.cs. The robot keeps its right hand on the wall: where there is an
// opening on the right it goes in, else straight on, else it turns left.
using System.Diagnostics;
using System.Globalization;
using System.Text;
using System.Text.Json;
using System.Text.Json.Nodes;
using System.Text.RegularExpressions;

// One cell of the maze is 100 cm wide.
const int Cell = 100;
// Farther than this, and there is no wall in the next cell.
const int Open = 60;

CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
try
{
    var robot = new Robot(args.Length == 0 ? "" : args[0]);
    await FollowRightWall(robot, Option("--until-cells", 0), Option("--moves", 2000));
    return 0;
}
catch (Exception error) when (error is RobotException or FormatException)
{
    Console.Error.WriteLine(error.Message);
    return 1;
}

int Option(string name, int otherwise)
{
    var at = Array.IndexOf(args, name);
    return at < 0 || at + 1 >= args.Length ? otherwise : int.Parse(args[at + 1]);
}

// Goes on until the goal is reached, or so many different cells are visited.
static async Task FollowRightWall(Robot robot, int untilCells, int mostMoves)
{
    var visited = new HashSet<(int, int)>();
    var moves = 0;
    while (true)
    {
        var view = await robot.Look();
        visited.Add(((int)(view.X / Cell), (int)(view.Y / Cell)));
        if (untilCells == 0 && view.GoalReached)
        {
            Console.WriteLine($"Goal reached after {moves} moves.");
            return;
        }
        if (untilCells > 0 && visited.Count >= untilCells)
        {
            Console.WriteLine($"{visited.Count} cells visited after {moves} moves.");
            return;
        }
        if (moves >= mostMoves)
        {
            throw new RobotException($"Not there after {moves} moves; {visited.Count} cells visited.");
        }
        string how;
        if (view.Right > Open)
        {
            Console.WriteLine($"{view.Right:F0} cm on the right: turn right and go");
            await robot.Right();
            how = await robot.Forward(Cell);
            moves++;
        }
        else if (view.Front > Open)
        {
            Console.WriteLine($"{view.Front:F0} cm ahead: go on");
            how = await robot.Forward(Cell);
            moves++;
        }
        else
        {
            Console.WriteLine("Wall ahead and on the right: turn left");
            how = await robot.Left();
        }
        if (how == "collided") Console.WriteLine("Bumped into a wall!");
    }
}

/// <summary>Something did not work; the text says what, and how to mend it.</summary>
class RobotException(string sentence) : Exception(sentence);

/// <summary>What the robot sees, in cm, and where it is.</summary>
record View(double Front, double Right, double X, double Y, bool GoalReached);

/// <summary>A robot somewhere on the network. Every method waits until the robot has done it.</summary>
class Robot
{
    // How long the service may stay silent until the program gives up.
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(30);
    private const double FirstPauseMs = 250;
    private const double LongestPauseMs = 10_000;

    // The key goes to the host of the address and to no other. The proxy is the system's.
    private readonly HttpClient http =
        new(new HttpClientHandler { AllowAutoRedirect = false }) { Timeout = TimeSpan.FromSeconds(20) };
    private readonly string api;
    private readonly string key;

    public Robot(string address)
    {
        var parts = Regex.Match(
            address.Trim(),
            @"^(https?://[^/?#\s@]+)/r/([A-Za-z0-9_-]{1,64})#([A-Za-z0-9_-]{8,64})$");
        if (!parts.Success)
        {
            throw new RobotException(
                "This is not a robot's address. Copy the whole address from the page, and put it in "
                + "\"quotes\": the part after the # is the key.");
        }
        api = $"{parts.Groups[1].Value}/api/v1/robots/{parts.Groups[2].Value}";
        key = parts.Groups[3].Value;
    }

    /// <summary>Drives so many cm. Gives "completed", or "collided" if a wall was in the way.</summary>
    public Task<string> Forward(double distance) =>
        Command(new JsonObject { ["action"] = "move", ["distance"] = distance });

    public Task<string> Left() => Command(new JsonObject { ["action"] = "left 90" });

    public Task<string> Right() => Command(new JsonObject { ["action"] = "right 90" });

    /// <summary>What the robot sees now, never from before the end of its last command.</summary>
    public async Task<View> Look()
    {
        var seen = await Ask(HttpMethod.Get, "/sensors?wait=10");
        return new View(
            (double)seen["sensors"]!["front"]!,
            (double)seen["sensors"]!["right"]!,
            (double)seen["pose"]!["x"]!,
            (double)seen["pose"]!["y"]!,
            (bool)seen["goalReached"]!);
    }

    // Sends a command, waits until it has ended, and gives how.
    private async Task<string> Command(JsonObject wish)
    {
        var record = await Ask(HttpMethod.Post, "/commands", wish);
        while (true)
        {
            var state = (string)record["state"]!;
            if (state is "completed" or "collided") return state;
            if (state is "cancelled" or "superseded" or "expired")
            {
                throw new RobotException($"{record["action"]} was {state}: {record["reason"]}");
            }
            record = await Ask(HttpMethod.Get, $"/commands/{record["seq"]}?wait=10");
        }
    }

    // One request to the service, tried again when the network or the service has a bad moment.
    private async Task<JsonNode> Ask(HttpMethod method, string path, JsonObject? wish = null)
    {
        // The key makes a retry safe: a command that arrives twice is done once.
        var once = Guid.NewGuid().ToString();
        var clock = Stopwatch.StartNew();
        for (var tries = 0; ; tries++)
        {
            string trouble;
            try
            {
                using var answer = await http.SendAsync(Request(method, path, wish, once, clock));
                var text = await answer.Content.ReadAsStringAsync();
                var status = (int)answer.StatusCode;
                if (answer.IsSuccessStatusCode) return Parse(text);
                trouble = Sentence(status, text);
                if (status != 429 && status < 500) throw new RobotException(trouble);
            }
            catch (Exception error) when (error is HttpRequestException or TaskCanceledException)
            {
                trouble = $"The service does not answer: {error.Message}";
            }
            // Drawn by lot, so that a whole class does not come back in the same moment.
            var limit = Math.Min(LongestPauseMs, FirstPauseMs * Math.Pow(2, tries));
            var pause = TimeSpan.FromMilliseconds(Random.Shared.NextDouble() * limit);
            if (clock.Elapsed + pause > Patience) throw new RobotException(trouble);
            await Task.Delay(pause);
        }
    }

    private HttpRequestMessage Request(
        HttpMethod method, string path, JsonObject? wish, string once, Stopwatch clock)
    {
        var request = new HttpRequestMessage(method, api + path);
        request.Headers.Add("Authorization", $"Bearer {key}");
        request.Headers.Add("User-Agent", ".NET-example");
        if (wish is null) return request;
        // How old the wish is: one that comes late is not done late.
        if (clock.ElapsedMilliseconds > 0) wish["age"] = clock.ElapsedMilliseconds;
        request.Headers.Add("Idempotency-Key", once);
        request.Content = new StringContent(wish.ToJsonString(), Encoding.UTF8, "application/json");
        return request;
    }

    private static JsonNode Parse(string text)
    {
        try
        {
            return JsonNode.Parse(text) ?? throw new JsonException();
        }
        catch (JsonException)
        {
            throw new RobotException("What answers at this address is not a robot's host.");
        }
    }

    // The sentence in which the service says what is wrong.
    private static string Sentence(int status, string text)
    {
        try
        {
            return (string?)JsonNode.Parse(text)?["detail"] ?? throw new JsonException();
        }
        catch (Exception error) when (error is JsonException or InvalidOperationException)
        {
            return $"The service answered with status {status}.";
        }
    }
}
