"""The transport with local servers: proxies, redirects, failures."""

import socket
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Callable, Dict, Iterator, List

import pytest
from corridor.transport import HttpTransport
from corridor.requests import Response, Request

Serve = Callable[[Callable[[BaseHTTPRequestHandler], None]], str]


@pytest.fixture
def serve() -> Iterator[Serve]:
    servers: List[ThreadingHTTPServer] = []

    def start(answer: Callable[[BaseHTTPRequestHandler], None]) -> str:
        class Handler(BaseHTTPRequestHandler):
            def do_GET(self) -> None:
                answer(self)

            def log_message(self, format: str, *args: object) -> None:
                return None

        server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        servers.append(server)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        return f"http://127.0.0.1:{server.server_port}"

    yield start
    for server in servers:
        server.shutdown()
        server.server_close()


def get(url: str, timeout: float = 5.0) -> Response:
    headers = {"Authorization": "Bearer drv_secret"}
    return HttpTransport().send(Request("GET", url, headers, None, timeout))


def plain(handler: BaseHTTPRequestHandler, status: int, headers: Dict[str, str], body: bytes) -> None:
    handler.send_response(status)
    for name, value in headers.items():
        handler.send_header(name, value)
    handler.end_headers()
    handler.wfile.write(body)


def test_requests_use_the_proxy_of_the_environment(
    serve: Serve, monkeypatch: pytest.MonkeyPatch
) -> None:
    proxy = serve(lambda handler: plain(handler, 200, {}, handler.path.encode()))
    monkeypatch.setenv("http_proxy", proxy)
    assert get("http://robots.invalid/r/1").body == b"http://robots.invalid/r/1"
    monkeypatch.setenv("no_proxy", "robots.invalid")
    assert get("http://robots.invalid/r/1").status == 0


def test_local_robots_are_reached_without_a_proxy(
    serve: Serve, monkeypatch: pytest.MonkeyPatch
) -> None:
    here = serve(lambda handler: plain(handler, 200, {}, b"here"))
    monkeypatch.setenv("http_proxy", "http://127.0.0.1:9")
    assert get(here).body == b"here"
    assert get(here.replace("127.0.0.1", "localhost")).body == b"here"


def test_the_key_is_not_sent_to_the_target_of_a_redirect(serve: Serve) -> None:
    requested: List[str] = []
    elsewhere = serve(lambda handler: requested.append(handler.path))
    here = serve(lambda handler: plain(handler, 302, {"Location": elsewhere}, b""))
    assert get(here).status == 302
    assert requested == []


def test_a_numeric_retry_after_is_read(serve: Serve) -> None:
    busy = serve(lambda handler: plain(handler, 429, {"Retry-After": "7"}, b"{}"))
    assert get(busy) == Response(429, b"{}", retry_after=7.0)
    late = serve(lambda handler: plain(handler, 503, {"Retry-After": "Mon, 1 Jan"}, b"{}"))
    assert get(late).retry_after is None


def test_an_incomplete_response_is_a_failure(serve: Serve) -> None:
    cut = serve(lambda handler: plain(handler, 200, {"Content-Length": "100"}, b"{"))
    assert get(cut).status == 0


def test_a_response_that_is_not_http_is_a_failure() -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        threading.Thread(target=lambda: server.accept()[0].sendall(b"SSH-2.0\r\n"), daemon=True).start()
        answer = get(f"http://127.0.0.1:{server.getsockname()[1]}")
    assert answer.status == 0 and answer.error


def test_silence_is_a_failure_after_the_timeout() -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        answer = get(f"http://127.0.0.1:{server.getsockname()[1]}", timeout=0.2)
    assert answer == Response(0, error="no response in time")


@pytest.mark.parametrize("host", ["…", "robots..example", "[::1"])
def test_a_host_that_no_request_can_have_is_a_failure(host: str) -> None:
    answer = get(f"http://{host}")
    assert answer.status == 0 and answer.error


def test_a_refused_connection_is_reported_without_the_key() -> None:
    answer = get("http://127.0.0.1:9")
    assert answer.status == 0
    assert "refused" in answer.error and "secret" not in answer.error
