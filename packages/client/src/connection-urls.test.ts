import { describe, expect, it } from "vitest";
import { connectionUrls } from "./connection-urls.ts";

describe("connectionUrls", () => {
  it("has a URL for each transport", () => {
    expect(connectionUrls("http://localhost:8080", "robots", "A")).toEqual({
      websocket: "ws://localhost:8080/api/v1/robots/A/socket",
      "long-poll": "http://localhost:8080/api/v1/robots/A/long-poll",
    });
  });

  it("is encrypted if the service is", () => {
    expect(connectionUrls("https://http.example", "classes", "A").websocket).toBe(
      "wss://http.example/api/v1/classes/A/socket",
    );
  });
});
