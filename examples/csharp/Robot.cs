// Follow the right-hand wall through a maze.
//
// Run it with the robot's address, as the page shows it under Remote (keep the quotes; where it cannot
// be copied, a code gets one: see the README of the examples):
//
//     dotnet run Robot.cs "http://localhost:8080/r/ID#KEY"
//
// That needs .NET 10 or newer and nothing else. With an older one, from .NET Core 3.1 on, put it into a
// project of `dotnet new console` in place of Program.cs. The robot keeps its right hand on the wall:
// where there is an opening on the right it goes in, else straight on, else it turns left.
#nullable enable
using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Net.Http;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;
using System.Threading.Tasks;

/// <summary>Something did not work; the text says what, and how to mend it.</summary>
class RobotException : Exception
{
    public RobotException(string sentence) : base(sentence) { }
}

/// <summary>What the robot sees, in cm, and where it is.</summary>
class View
{
    public double Front, Right, X, Y;
    public bool GoalReached;
}

/// <summary>A robot somewhere on the network. Every method waits until the robot has done it.</summary>
class Robot
{
    // What the robot's owner sees of this program.
    private const string Name = "Right wall";
    // How long the service may stay silent until the program gives up.
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(30);
    private const double FirstPauseMs = 250;
    private const double LongestPauseMs = 10_000;

    // The key goes to the host of the address and to no other. The proxy is the system's.
    private readonly HttpClient http =
        new HttpClient(new HttpClientHandler { AllowAutoRedirect = false }) { Timeout = TimeSpan.FromSeconds(20) };
    private readonly Random random = new Random();
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
        Command($"\"action\":\"move\",\"distance\":{distance.ToString(CultureInfo.InvariantCulture)}");

    public Task<string> Left() => Command("\"action\":\"left 90\"");

    public Task<string> Right() => Command("\"action\":\"right 90\"");

    /// <summary>What the robot sees now, never from before the end of its last command.</summary>
    public async Task<View> Look()
    {
        var seen = await Ask(HttpMethod.Get, "/sensors?wait=10");
        var sensors = seen.GetProperty("sensors");
        var pose = seen.GetProperty("pose");
        return new View
        {
            Front = sensors.GetProperty("front").GetDouble(),
            Right = sensors.GetProperty("right").GetDouble(),
            X = pose.GetProperty("x").GetDouble(),
            Y = pose.GetProperty("y").GetDouble(),
            GoalReached = seen.GetProperty("goalReached").GetBoolean(),
        };
    }

    // Sends a command, waits until it has ended, and gives how.
    private async Task<string> Command(string fields)
    {
        var record = await Ask(HttpMethod.Post, "/commands", fields);
        while (true)
        {
            var state = record.GetProperty("state").GetString() ?? "";
            switch (state)
            {
                case "completed":
                case "collided":
                    return state;
                case "cancelled":
                case "superseded":
                case "expired":
                    var action = record.GetProperty("action");
                    throw new RobotException($"{action} was {state}: {record.GetProperty("reason")}");
            }
            record = await Ask(HttpMethod.Get, $"/commands/{record.GetProperty("seq")}?wait=10");
        }
    }

    // One request to the service, tried again when the network or the service has a bad moment.
    private async Task<JsonElement> Ask(HttpMethod method, string path, string? fields = null)
    {
        // The key makes a retry safe: a command that arrives twice is done once.
        var once = Guid.NewGuid().ToString();
        var clock = Stopwatch.StartNew();
        for (var tries = 0; ; tries++)
        {
            string trouble;
            try
            {
                using var request = Request(method, path, fields, once, clock.ElapsedMilliseconds);
                using var answer = await http.SendAsync(request);
                var text = await answer.Content.ReadAsStringAsync();
                var status = (int)answer.StatusCode;
                if (answer.IsSuccessStatusCode) return Parse(text);
                trouble = Sentence(status, text);
                if (status != 429 && status < 500) throw new RobotException(trouble);
            }
            catch (Exception error) when (
                error is HttpRequestException || error is IOException || error is TaskCanceledException)
            {
                trouble = $"The service does not answer: {error.Message}";
            }
            // Drawn by lot, so that a whole class does not come back in the same moment.
            var limit = Math.Min(LongestPauseMs, FirstPauseMs * Math.Pow(2, tries));
            var pause = TimeSpan.FromMilliseconds(random.NextDouble() * limit);
            if (clock.Elapsed + pause > Patience) throw new RobotException(trouble);
            await Task.Delay(pause);
        }
    }

    private HttpRequestMessage Request(HttpMethod method, string path, string? fields, string once, long age)
    {
        var request = new HttpRequestMessage(method, api + path);
        request.Headers.Add("Authorization", $"Bearer {key}");
        request.Headers.Add("Script-Name", Name);
        request.Headers.Add("User-Agent", ".NET-example");
        if (fields == null) return request;
        // How old the wish is: one that comes late is not done late.
        var body = age == 0 ? $"{{{fields}}}" : $"{{{fields},\"age\":{age}}}";
        request.Headers.Add("Idempotency-Key", once);
        request.Content = new StringContent(body, Encoding.UTF8, "application/json");
        return request;
    }

    private static JsonElement Parse(string text)
    {
        try
        {
            return JsonDocument.Parse(text).RootElement;
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
            var detail = JsonDocument.Parse(text).RootElement.GetProperty("detail").GetString();
            if (detail != null) return detail;
        }
        catch (Exception error) when (
            error is JsonException || error is InvalidOperationException || error is KeyNotFoundException)
        {
            // Something on the way has answered, not the service.
        }
        return $"The service answered with status {status}.";
    }
}

static class Program
{
    // One cell of the maze is 100 cm wide.
    private const int Cell = 100;
    // Farther than this, and there is no wall in the next cell.
    private const int Open = 60;

    static async Task<int> Main(string[] args)
    {
        CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
        try
        {
            var robot = new Robot(args.Length == 0 ? "" : args[0]);
            await FollowRightWall(robot, Option(args, "--until-cells", 0), Option(args, "--moves", 2000));
            return 0;
        }
        catch (Exception error) when (error is RobotException || error is FormatException)
        {
            Console.Error.WriteLine(error.Message);
            return 1;
        }
    }

    // A whole number of an option, which stands after its name.
    static int Option(string[] args, string name, int otherwise)
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
}
