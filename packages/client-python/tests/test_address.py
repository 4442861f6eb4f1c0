"""What a reader is told about an address that is not whole, and that no key shows in it."""

import pytest
from corridor import AddressError
from corridor.address import parse_address

KEY = "drv_AAAAAAAAAAAAAAAAAAAAAA"


def test_the_address_of_the_page_is_taken_apart() -> None:
    address = parse_address(f"  http://localhost:8080/r/blue-otter-42#{KEY}\n")
    assert address.api == "http://localhost:8080/api/v1/robots/blue-otter-42"
    assert address.key == KEY


def test_the_key_may_be_given_by_itself() -> None:
    assert parse_address("https://host.example/r/abc", f" {KEY} ").key == KEY
    assert parse_address("https://host.example/r/abc#drv_of_somebody_else", KEY).key == KEY


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("", "It is empty"),
        ("localhost/r/abc#" + KEY, "begins with http://"),
        ("http://localhost:8080/r/abc", "key after the # is missing"),
        ("http://localhost:8080/r/abc#", "key after the # is missing"),
        ("http://HOST/r/ID#KEY", "HOST, ID and KEY stand for your robot's address"),
        ("http://localhost:8080/#" + KEY, "looks like http://HOST/r/ID#KEY"),
        ("http://localhost:8080/r/abc?key=" + KEY, "key after the # is missing"),
        ("http://me:secret@localhost/r/abc#" + KEY, "before the @"),
        ("http://localhost/r/abc#" + "k" * 500, "looks like http://HOST/r/ID#KEY"),
    ],
)
def test_a_wrong_address_is_told_with_the_usual_mistake(text: str, hint: str) -> None:
    with pytest.raises(AddressError, match=hint) as error:
        parse_address(text)
    assert error.value.code == "bad-address"
    assert KEY not in str(error.value)
    assert "secret" not in str(error.value)


def test_something_else_than_text_is_no_address() -> None:
    with pytest.raises(AddressError, match="text in quotes"):
        parse_address(None)  # type: ignore[arg-type]


def test_the_key_shows_in_no_picture_of_the_address() -> None:
    assert KEY not in repr(parse_address(f"http://localhost/r/abc#{KEY}"))
