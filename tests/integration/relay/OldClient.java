import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.net.http.WebSocket;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;

/** Java's own HTTP client with its defaults: it offers "Upgrade: h2c" with every request. */
public class OldClient {
  public static void main(String[] arguments) throws Exception {
    String api = arguments[0];
    String key = arguments[1];
    HttpClient client = HttpClient.newHttpClient();
    HttpRequest post =
        HttpRequest.newBuilder(URI.create(api + "/commands"))
            .header("Authorization", "Bearer " + key)
            .header("Content-Type", "application/json")
            .POST(HttpRequest.BodyPublishers.ofString("{\"action\":\"left 90\"}"))
            .build();
    System.out.println(client.send(post, BodyHandlers.ofString()).statusCode());

    CompletableFuture<String> first = new CompletableFuture<>();
    WebSocket socket =
        client
            .newWebSocketBuilder()
            .buildAsync(
                URI.create(api.replaceFirst("http", "ws") + "/socket"),
                new WebSocket.Listener() {
                  @Override
                  public CompletionStage<?> onText(WebSocket s, CharSequence text, boolean last) {
                    first.complete(text.toString());
                    return null;
                  }
                })
            .get(10, TimeUnit.SECONDS);
    String hello =
        "{\"type\":\"hello\",\"version\":1,\"role\":\"drive\",\"key\":\"" + key + "\"}";
    socket.sendText(hello, true);
    System.out.println(first.get(10, TimeUnit.SECONDS));
    socket.abort();
  }
}
