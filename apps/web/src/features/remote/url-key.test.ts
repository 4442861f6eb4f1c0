import { describe, expect, it } from "vitest";
import { MemoryStorage } from "../../model/storage/testing/memory-storage.ts";
import { keyIdOf } from "./key-id.ts";
import type { Ask } from "./owner-calls.ts";
import { dropUrlKey, provideUrlKey, readUrlKey } from "./url-key.ts";

const robot = { id: "A".repeat(22), ownerKey: "own_secret" };

/** A service that makes keys `url_1`, `url_2` and so on. */
function service(status = 201) {
  const asked: string[] = [];
  const ask: Ask = async (url, { method = "GET", body = "" }) => {
    asked.push(`${method} ${url} ${body}`);
    const key = `url_${asked.length}`;
    const urls = { ros: `ws://host/r/x/ros/${key}`, mcp: null };
    const made = { id: keyIdOf(key), kind: "drive", key, address: null, urls };
    return Response.json(status === 201 ? made : {}, { status });
  };
  return { asked, ask };
}

describe("the key for URLs", () => {
  it("is created once, for two requests at a time and after a reload", async () => {
    const { asked, ask } = service();
    const tab = new MemoryStorage();
    const both = [provideUrlKey(ask, tab, robot), provideUrlKey(ask, tab, robot)];
    expect(await Promise.all(both)).toEqual(["url_1", "url_1"]);
    expect(await provideUrlKey(ask, tab, robot)).toBe("url_1");
    expect(readUrlKey(tab, robot.id)).toBe("url_1");
    expect(asked).toEqual([`POST /api/v1/robots/${robot.id}/keys {"kind":"drive","use":"url"}`]);
  });

  it("belongs to one robot", async () => {
    const { ask } = service();
    const tab = new MemoryStorage();
    await provideUrlKey(ask, tab, robot);
    const other = { ...robot, id: "B".repeat(22) };
    expect(readUrlKey(tab, other.id)).toBeNull();
    expect(await provideUrlKey(ask, tab, other)).toBe("url_2");
  });

  it("is created again after its owner revoked it, but not after another key was revoked", async () => {
    const { ask } = service();
    const tab = new MemoryStorage();
    await provideUrlKey(ask, tab, robot);
    dropUrlKey(tab, keyIdOf("another"));
    expect(await provideUrlKey(ask, tab, robot)).toBe("url_1");
    dropUrlKey(tab, keyIdOf("url_1"));
    expect(await provideUrlKey(ask, tab, robot)).toBe("url_2");
  });

  it("is missing if the service refuses it, and the next request tries again", async () => {
    const tab = new MemoryStorage();
    expect(await provideUrlKey(service(409).ask, tab, robot)).toBeNull();
    expect(await provideUrlKey(service().ask, tab, robot)).toBe("url_1");
  });

  it("works without a stored key if the storage is full", async () => {
    const tab = new MemoryStorage();
    tab.isFull = true;
    expect(await provideUrlKey(service().ask, tab, robot)).toBe("url_1");
    expect(readUrlKey(tab, robot.id)).toBeNull();
  });
});
